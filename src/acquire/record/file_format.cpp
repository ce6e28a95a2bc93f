#include "acquire/record/file_format.hpp"

#include <filesystem>

#include "core/io/csv_header.hpp"

namespace percuss::acquire {

std::string file_extension(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace percuss::acquire
