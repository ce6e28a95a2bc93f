#include "core/io/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace percuss {
inline namespace core {

std::string temporary_template(const std::string& prefix) {
  std::error_code problem;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(problem);
  return ((problem ? std::filesystem::path("/tmp") : folder) / (prefix + "-XXXXXX")).string();
}

TemporaryFolder::TemporaryFolder(const std::string& prefix) : path_(temporary_template(prefix)) {
  if (::mkdtemp(path_.data()) == nullptr)
    throw_system_error("cannot make a folder", errno, path_, "free some room, or set TMPDIR to another folder");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace core
}  // namespace percuss
