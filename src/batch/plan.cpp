#include "batch/plan.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <string_view>
#include <system_error>

#include "acquire/format_registry.hpp"
#include "acquire/record/files_of_hits.hpp"
#include "batch/sha256_file.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/natural_order.hpp"
#include "core/visible_text.hpp"

namespace percuss::batch {
namespace {

namespace fs = std::filesystem;

class CollectedFiles {
 public:
  void add(const std::string& path) {
    if (seen_.insert(path).second) files_.paths.push_back(path);
  }
  void add_folder(const std::string& folder) {
    std::vector<std::string> found, others;
    std::error_code problem;
    auto at = fs::recursive_directory_iterator(folder, problem);
    for (; !problem && at != fs::recursive_directory_iterator(); at.increment(problem)) {
      const bool hidden = at->path().filename().string().starts_with('.');
      std::error_code ignored;
      if (hidden && at->is_directory(ignored)) at.disable_recursion_pending();
      if (hidden || !at->is_regular_file(ignored)) continue;
      if (acquire::has_known_extension(at->path().string())) {
        found.push_back(at->path().string());
      } else {
        others.push_back(at->path().string());
      }
    }
    if (problem) throw InputError("cannot read the folder: " + problem.message(), folder, "check its permissions");
    std::sort(found.begin(), found.end(), comes_first_naturally);
    std::sort(others.begin(), others.end(), comes_first_naturally);
    for (const std::string& path : found) add(path);
    files_.left_out.insert(files_.left_out.end(), others.begin(), others.end());
  }
  void add_pattern(const std::string& pattern) {
    glob_t matches{};
    const std::unique_ptr<glob_t, decltype(&::globfree)> owner(&matches, &::globfree);
    // A folder that does not exist has no match; one that cannot be read ends the search.
    const auto ends_search = [](const char*, int error) { return error == ENOENT || error == ENOTDIR ? 0 : 1; };
    const int outcome = ::glob(pattern.c_str(), 0, ends_search, &matches);
    if (outcome == GLOB_NOSPACE) throw std::bad_alloc();
    if (outcome == GLOB_ABORTED)
      throw InputError("a folder of the pattern cannot be read", pattern, "check its permissions");
    if (outcome != 0) throw InputError("no file matches the pattern", pattern, "check the path");
    std::vector<std::string> found(matches.gl_pathv, matches.gl_pathv + matches.gl_pathc);
    std::sort(found.begin(), found.end(), comes_first_naturally);
    for (const std::string& path : found) add_named(path);
  }
  void add_named(const std::string& name) {
    std::error_code ignored;
    if (fs::is_directory(name, ignored)) {
      add_folder(name);
    } else if (is_pattern(name)) {
      add_pattern(name);
    } else {
      first_bytes(name, 0);  // checks that the file exists and can be read
      add(name);
    }
  }
  RecordFiles result() { return std::move(files_); }

 private:
  RecordFiles files_;
  std::set<std::string> seen_;
};

// An absolute path stays. A relative path becomes relative to the folder, without resolving symbolic links. If the
// result names another file, the links are resolved first.
std::string path_from(const std::string& path, const fs::path& folder) {
  const fs::path given(path);
  if (given.is_absolute()) return given.lexically_normal().string();
  const fs::path named = fs::absolute(given).lexically_normal().lexically_relative(folder);
  std::error_code ignored;
  if (fs::equivalent(folder / named, given, ignored)) return named.string();
  return fs::relative(given, folder).string();
}

}  // namespace

bool is_pattern(const std::string& name) {
  const std::size_t bracket = name.find('[');
  const bool set = bracket != std::string::npos && name.find(']', bracket) != std::string::npos;
  std::error_code ignored;
  return (set || name.find_first_of("*?") != std::string::npos) && !fs::exists(name, ignored);
}

RecordFiles record_files(const std::vector<std::string>& named) {
  CollectedFiles gathered;
  for (const std::string& name : named) gathered.add_named(name);
  return gathered.result();
}

std::vector<std::string> parse_path_list(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty()) names.emplace_back(line);
  }
  return names;
}

std::vector<BatchRecord> records_of_files(const std::vector<std::string>& paths, const std::string& manifest_folder,
                                          bool hashed) {
  const fs::path folder = (fs::absolute(manifest_folder) / "").lexically_normal();
  std::map<std::string, BatchRecord> by_path;
  std::map<std::string, std::size_t> times;  // how often each name without extension occurs
  for (const std::string& path : paths) {
    if (!is_utf8(path)) throw InputError("the file's name is not UTF-8", path, "rename it");
    BatchRecord record{.id = fs::path(path).stem().string(), .path = path_from(path, folder)};
    record.bytes = fs::file_size(path);
    if (hashed) record.sha256 = sha256_of_record(path);
    if (by_path.emplace(record.path, record).second) ++times[record.id];
  }
  std::vector<BatchRecord> records;
  records.reserve(by_path.size());
  for (const auto& [path, record] : by_path) {
    records.push_back(record);
    if (times.at(record.id) > 1 || by_path.contains(record.id)) records.back().id = path;
  }
  std::sort(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return records;
}

std::vector<HitsOfOnePart> hits_of_one_part(const std::vector<std::string>& paths) {
  std::vector<HitsOfOnePart> out;
  for (const acquire::FilesOfHits& group : acquire::files_called_hits(paths)) {
    const fs::path stem(group.stem);
    const fs::path part = stem.has_filename() ? stem.filename() : stem.parent_path().filename();
    out.push_back({.part = part.string(), .paths = {}});
    for (const std::size_t file : group.files) out.back().paths.push_back(paths[file]);
    std::sort(out.back().paths.begin(), out.back().paths.end(), comes_first_naturally);
  }
  return out;
}

}  // namespace percuss::batch
