#include "cli/open_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

#include "acquire/open_measurement.hpp"
#include "batch/plan.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kFlopsPerFile = 1'000'000;  // cost of opening a file, in floating-point operations

void require_distinct(const std::vector<std::string>& paths) {
  std::set<std::string> seen;
  for (const auto& path : paths) {
    if (!seen.insert(path).second)
      throw OptionError({}, fmt::format("\"{}\" is given twice", one_line(path)), "name each file once");
  }
}

bool has_in_memory_inputs(const ReadFlags& flags) { return flags.host != nullptr && !flags.host->inputs.empty(); }

std::size_t input_count(const ReadFlags& flags) {
  return has_in_memory_inputs(flags) ? flags.host->inputs.size() : flags.paths.size();
}

void require_files(const ReadFlags& flags) {
  if (has_in_memory_inputs(flags)) return;
  if (flags.paths.empty()) throw OptionError({}, "no file is given", "name at least one, or - for standard input");
  require_distinct(flags.paths);
}

// A single file needs no fork server.
bool several_with_sandboxed_format(const ReadFlags& flags) {
  return flags.paths.size() > 1 && std::any_of(flags.paths.begin(), flags.paths.end(), [](const std::string& path) {
           return path != "-" && acquire::needs_sandbox(path);
         });
}

// The fork server that starts the sandboxes of several files, since a process with running threads cannot fork safely.
// A host may have threads of its own at any time.
std::shared_ptr<acquire::ForkServer> fork_server_for(const ReadFlags& flags, const acquire::ReadOptions& options) {
  const bool alike = options.force_scale.size() <= 1;
  if (flags.host != nullptr || !options.sandboxed || !alike || !several_with_sandboxed_format(flags)) return nullptr;
  return acquire::measurement_fork_server({.read = options, .kind = flags.frf_kind});
}

// Opens the files in parallel, except sandboxed ones without a fork server. Rethrows the error of the first file that
// cannot be opened.
template <class Opened, class Open>
std::vector<std::optional<Opened>> for_each_file(const ReadFlags& flags, bool fork_server, const Open& open) {
  std::vector<std::optional<Opened>> opened(input_count(flags));
  std::vector<std::exception_ptr> failed(opened.size());
  const bool forks = !fork_server && several_with_sandboxed_format(flags);
  parallel_for_cost(opened.size(), forks ? 0 : kFlopsPerFile, [&](std::size_t i) {
    try {
      opened[i].emplace(open(i));
    } catch (...) {
      failed[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : failed) {
    if (error) std::rethrow_exception(error);
  }
  return opened;
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

}  // namespace

std::vector<std::string> found_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!is_folder(path) && !batch::is_pattern(path)) {
      files.push_back(path);
      continue;
    }
    const std::vector<std::string> found = batch::record_files({path}).paths;
    if (found.empty()) throw InputError("no file of a known kind in the folder", path, "name the files");
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

ReadFlags with_found_files(const ReadFlags& given) {
  ReadFlags flags = given;
  if (!has_in_memory_inputs(flags)) flags.paths = found_files(given.paths);
  return flags;
}

acquire::Record open_record_at(const ReadFlags& flags, const acquire::ReadOptions& options, std::size_t index) {
  const acquire::ReadOptions file_options = read_options_of_file(options, index, input_count(flags));
  if (!has_in_memory_inputs(flags)) return acquire::open_record(flags.paths[index], file_options);
  auto given = flags.host->inputs[index]({.read = file_options, .kind = flags.frf_kind});
  if (auto* record = std::get_if<acquire::Record>(&given)) return std::move(*record);
  throw InputError("the file holds FRFs, not a record", std::get<acquire::FrfRecord>(given).source(),
                   "give force and acceleration");
}

std::variant<acquire::Record, acquire::FrfRecord> open_measurement_at(const ReadFlags& flags,
                                                                      const acquire::ReadOptions& options,
                                                                      std::size_t index) {
  const acquire::FrfReadOptions file_options{.read = read_options_of_file(options, index, input_count(flags)),
                                             .kind = flags.frf_kind};
  return has_in_memory_inputs(flags) ? flags.host->inputs[index](file_options)
                                     : acquire::open_measurement(flags.paths[index], file_options);
}

Measurements open_measurements(const ReadFlags& given) {
  std::optional<ReadFlags> found;
  if (!has_in_memory_inputs(given)) found = with_found_files(given);
  const ReadFlags& flags = found ? *found : given;
  require_files(flags);
  const acquire::ReadOptions options = resolved_read_options(flags);
  const auto fork_server = fork_server_for(flags, options);
  auto all = for_each_file<std::variant<acquire::Record, acquire::FrfRecord>>(
      flags, fork_server != nullptr, [&](std::size_t i) {
        if (fork_server == nullptr) return open_measurement_at(flags, options, i);
        return acquire::open_measurement_forked(fork_server, flags.paths[i], {.read = options, .kind = flags.frf_kind});
      });
  Measurements out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (auto* record = std::get_if<acquire::Record>(&*all[i])) out.records.push_back(std::move(*record));
    if (auto* frfs = std::get_if<acquire::FrfRecord>(&*all[i])) out.frfs.push_back(std::move(*frfs));
    if (out.records.empty() || out.frfs.empty()) continue;
    throw InputError("records and FRFs cannot be joined",
                     has_in_memory_inputs(flags) ? "data in memory" : flags.paths[i],
                     "analyse the two kinds separately");
  }
  return out;
}

acquire::FrfRecord join_frfs_of(const ReadFlags& flags, std::vector<acquire::FrfRecord> frfs) {
  if (frfs.size() > 1 && flags.files == acquire::FileGrouping::hits)
    throw OptionError({"files"}, "cannot be 'hits' for FRFs, which hold no hits", "give points or tests");
  return acquire::join_frfs(std::move(frfs));
}

std::vector<acquire::Record> open_records(const ReadFlags& given) {
  const ReadFlags flags = with_found_files(given);
  require_files(flags);
  const acquire::ReadOptions options = resolved_read_options(flags);
  auto all =
      for_each_file<acquire::Record>(flags, false, [&](std::size_t i) { return open_record_at(flags, options, i); });
  std::vector<acquire::Record> records;
  records.reserve(all.size());
  for (auto& record : all) records.push_back(std::move(*record));
  return records;
}

}  // namespace percuss::tools
