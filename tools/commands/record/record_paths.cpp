#include "commands/record/record_paths.hpp"

#include <algorithm>
#include <system_error>

#include "batch/sha256_file.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

// "sim:" "SPEC" ",hits=3".
struct DeviceFile {
  std::string kind, path, rest;
};

DeviceFile file_of(const std::string& device) {
  for (const char* kind : {"file:", "sim:", "plugin:"}) {
    const std::string prefix = kind;
    if (!device.starts_with(prefix)) continue;
    const std::string text = device.substr(prefix.size());
    const std::size_t end = prefix == "file:" ? text.size() : text.find(prefix == "sim:" ? ',' : ':');
    const std::size_t length = std::min(end, text.size());
    return {prefix, text.substr(0, length), text.substr(length)};
  }
  return {.kind = device, .path = {}, .rest = {}};
}

bool path_exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

SessionPaths::SessionPaths(const std::string& folder, const std::string& journal) {
  std::error_code ignored;
  if (!folder.empty() && fs::path(folder) != fs::current_path(ignored)) {
    folder_ = folder;
    bases_.push_back(folder_);
  }
  bases_.emplace_back();  // the present folder
  bases_.push_back(fs::path(journal).parent_path());
}

std::string SessionPaths::find(const std::string& path, const std::string& sha256) const {
  if (path.empty() || fs::path(path).is_absolute()) return path;
  std::string first;
  for (const fs::path& base : bases_) {
    std::string place = base / path;
    if (!path_exists(place)) continue;
    if (sha256.empty() || batch::sha256_of_record(place) == sha256) return place;
    if (first.empty()) first = place;
  }
  return first.empty() ? path : first;
}

std::string SessionPaths::find_device(const std::string& device) const {
  const DeviceFile file = file_of(device);
  return file.kind + find(file.path) + file.rest;
}

std::string SessionPaths::target(const std::string& path) const {
  return path.empty() || folder_.empty() || !path_exists(folder_) ? path : (folder_ / path).string();
}

bool names_same_file(const std::string& a, const std::string& b) {
  std::error_code failed;
  const auto place = [&](const std::string& path) { return fs::weakly_canonical(fs::absolute(path), failed); };
  return a == b || (place(a) == place(b) && !failed);
}

bool names_same_device(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const DeviceFile first = file_of(a), second = file_of(b);
  return first.kind == second.kind && first.rest == second.rest && path_exists(first.path) &&
         names_same_file(first.path, second.path);
}

}  // namespace percuss::tools
