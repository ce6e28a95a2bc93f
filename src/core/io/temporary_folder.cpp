#include "core/io/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace percuss {
inline namespace core {

TemporaryFolder::TemporaryFolder(const std::string& prefix) {
  std::error_code problem;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(problem);
  path_ = ((problem ? std::filesystem::path("/tmp") : folder) / (prefix + "-XXXXXX")).string();
  if (::mkdtemp(path_.data()) == nullptr)
    throw_system_error("cannot make a folder", errno, path_, "free some room, or set TMPDIR to another folder");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace core
}  // namespace percuss
