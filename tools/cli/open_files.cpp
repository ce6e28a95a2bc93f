#include "cli/open_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/open_measurement.hpp"
#include "batch/plan.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/natural_order.hpp"
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
// With a host there is none: the host may have threads already, and starting the server is a fork.
std::shared_ptr<acquire::ForkServer> fork_server_for(const ReadFlags& flags, const acquire::ReadOptions& options) {
  const bool alike = options.force_scale.size() <= 1;
  if (flags.host != nullptr || !options.sandboxed || !alike || !several_with_sandboxed_format(flags)) return nullptr;
  return acquire::measurement_fork_server(frf_read_options(flags, options));
}

// The files to open, in their order.
struct OrderedFiles {
  ReadFlags flags;                        // with their paths
  std::set<std::string> named;            // the paths as typed; others were found in folders and by patterns
  std::optional<Message> order_note;      // set if the order differs from the given one
  std::optional<Message> extension_note;  // files of folders that were left out by their extensions
  bool was_found(std::size_t i) const { return i < flags.paths.size() && !named.contains(flags.paths[i]); }
};

std::string file_name(const std::string& path) { return one_line(std::filesystem::path(path).filename().string(), 40); }

// "a.log, b.dat and 3 more"
std::string listed_names(const std::vector<std::string>& paths) {
  constexpr std::size_t kMaxNamed = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(paths.size(), kMaxNamed); ++i)
    names += (i > 0 ? ", " : "") + file_name(paths[i]);
  return paths.size() > kMaxNamed ? fmt::format("{} and {} more", names, paths.size() - kMaxNamed) : names;
}

// Whether the file was refused as a text without numbers, such as a README.
bool is_no_record(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const NoNumbers&) {
    return true;
  } catch (...) {
    return false;
  }
}

// Refuses a table of something else, such as a set-up, beside the records of a folder. The error of the file alone
// would suggest a command that reads it as a record.
void refuse_beside_others(const std::exception_ptr& error, const std::string& path) {
  try {
    std::rethrow_exception(error);
  } catch (const acquire::AmbiguousColumns& ambiguous) {
    if (ambiguous.roles_known) return;
    throw InputError(
        ambiguous.problem(), path,
        "if it is not a test like the other files of the folder, move it, or name the others by a pattern");
  } catch (...) {  // another error stays the same
  }
}

// A file that cannot be opened.
struct BadFile {
  std::string path;
  std::exception_ptr error;
};

// "README.txt: fewer than two samples". Rethrows an error that the file does not cause.
std::string problem_of(const BadFile& file) {
  constexpr std::size_t kMaxProblem = 60;  // bytes: five of them fit into a message
  try {
    std::rethrow_exception(file.error);
  } catch (const MachineFault&) {
    throw;
  } catch (const InputError& error) {
    return file_name(file.path) + ": " + one_line(error.problem(), kMaxProblem);
  }
}

// Names several unreadable files in one message, so that a user can clean up a folder at once.
[[noreturn]] void refuse_all(const std::vector<BadFile>& bad, std::size_t files, bool found) {
  constexpr std::size_t kMaxBad = 5;
  std::string list;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const std::string problem = problem_of(bad[i]);
    if (i < kMaxBad) list += (i > 0 ? "; " : "") + problem;
  }
  if (bad.size() > kMaxBad) list += fmt::format("; and {} more", bad.size() - kMaxBad);
  const std::string folder = std::filesystem::path(bad.front().path).parent_path().string();
  throw InputError(fmt::format("{} of {} files cannot be read: {}", bad.size(), files, list),
                   folder.empty() ? "." : folder,
                   found ? "move them elsewhere, or name the others by a pattern" : "leave them out");
}

// Opens the files in parallel; one after another if some need a sandbox and there is no fork server. Leaves out files
// found in folders that contain no numbers. Refuses all other unreadable files in one message; rethrows the first error
// if only one file is unreadable, or if no file can be opened.
template <class Opened, class Open>
std::vector<std::optional<Opened>> for_each_file(const OrderedFiles& found, bool fork_server, const Open& open) {
  const ReadFlags& flags = found.flags;
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
  const bool any = std::any_of(opened.begin(), opened.end(), [](const auto& one) { return one.has_value(); });
  std::vector<BadFile> bad;
  bool all_found = true;  // in folders or by patterns
  for (std::size_t i = 0; i < failed.size(); ++i) {
    if (!failed[i] || (any && found.was_found(i) && is_no_record(failed[i]))) continue;
    bad.push_back({has_in_memory_inputs(flags) ? std::string() : flags.paths[i], failed[i]});
    all_found = all_found && found.was_found(i);
  }
  if (bad.empty()) return opened;
  if (any && bad.size() > 1 && !has_in_memory_inputs(flags)) refuse_all(bad, failed.size(), all_found);
  if (any && all_found) refuse_beside_others(bad.front().error, bad.front().path);
  std::rethrow_exception(bad.front().error);
}

// The note on the files that for_each_file() left out.
template <class Opened>
std::optional<Message> left_out_note(const OrderedFiles& found, const std::vector<std::optional<Opened>>& opened) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < opened.size(); ++i) {
    if (!opened[i]) paths.push_back(found.flags.paths[i]);
  }
  if (paths.empty()) return std::nullopt;
  return information(fmt::format("left out, because {} no numbers: {}", paths.size() == 1 ? "it holds" : "they hold",
                                 listed_names(paths)));
}

// Puts the files of an unquoted pattern, which the shell gave as "p1 p10 p2", into their natural order, each with its
// force scale. Returns a note if the order changed.
std::optional<Message> order_naturally(ReadFlags& flags) {
  const std::vector<std::size_t> order = intended_order(flags.paths);
  const auto moved = std::adjacent_find(order.begin(), order.end(), std::greater<>());
  if (moved == order.end()) return std::nullopt;
  const std::vector<std::string> paths = flags.paths;
  const std::vector<double> scales = flags.options.force_scale;
  for (std::size_t i = 0; i < order.size(); ++i) {
    flags.paths[i] = paths[order[i]];
    if (scales.size() == paths.size()) flags.options.force_scale[i] = scales[order[i]];
  }
  const auto name = [&](std::size_t i) { return file_name(flags.paths[i]); };
  const auto at = static_cast<std::size_t>(moved - order.begin());
  return information(
      fmt::format("the files came in a shell's order of characters and are counted by the numbers in their names, {} "
                  "before {}; to count them in another order, rename them",
                  name(at), name(at + 1)));
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

OrderedFiles found_in_order(const ReadFlags& given) {
  OrderedFiles found{
      .flags = given, .named = {given.paths.begin(), given.paths.end()}, .order_note = {}, .extension_note = {}};
  if (has_in_memory_inputs(given)) return found;
  FoundFiles files = found_files(given.paths);
  found.flags.paths = std::move(files.paths);
  if (!files.left_out.empty()) {
    found.extension_note = information(fmt::format("left out, because {} known extension: {}; name a file to read it",
                                                   files.left_out.size() == 1 ? "it has no" : "they have no",
                                                   listed_names(files.left_out)));
  }
  found.order_note = order_naturally(found.flags);
  if (given.files == acquire::FileGrouping::tests) found.order_note.reset();  // tests are told apart by their names
  return found;
}

// Adds the notes to the record or the FRFs of each file.
template <class Opened>
void add_notes(const OrderedFiles& found, const std::optional<Message>& left_out, Opened& one) {
  if (found.order_note) one.notes.push_back(*found.order_note);
  if (left_out) one.notes.push_back(*left_out);
  if (found.extension_note) one.notes.push_back(*found.extension_note);
}

}  // namespace

FoundFiles found_files(const std::vector<std::string>& paths) {
  FoundFiles files;
  for (const std::string& path : paths) {
    if (!is_folder(path) && !batch::is_pattern(path)) {
      files.paths.push_back(path);
      continue;
    }
    const batch::RecordFiles found = batch::record_files({path});
    if (found.paths.empty()) throw InputError("no file of a known kind in the folder", path, "name the files");
    files.paths.insert(files.paths.end(), found.paths.begin(), found.paths.end());
    files.left_out.insert(files.left_out.end(), found.left_out.begin(), found.left_out.end());
  }
  return files;
}

std::vector<std::string> matched_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    const std::vector<std::string> found =
        batch::is_pattern(path) ? batch::record_files({path}).paths : std::vector<std::string>{path};
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

ReadFlags with_found_files(const ReadFlags& given) { return found_in_order(given).flags; }

acquire::Record open_record_at(const ReadFlags& flags, const acquire::ReadOptions& options, std::size_t index) {
  const acquire::ReadOptions file_options = read_options_of_file(options, index, input_count(flags));
  if (!has_in_memory_inputs(flags)) return acquire::open_record(flags.paths[index], file_options);
  auto given = flags.host->inputs[index](frf_read_options(flags, file_options));
  if (auto* record = std::get_if<acquire::Record>(&given)) return std::move(*record);
  throw InputError("the file holds FRFs, not a record", std::get<acquire::FrfRecord>(given).source(),
                   "give force and acceleration");
}

std::variant<acquire::Record, acquire::FrfRecord> open_measurement_at(const ReadFlags& flags,
                                                                      const acquire::ReadOptions& options,
                                                                      std::size_t index) {
  const acquire::FrfReadOptions file_options =
      frf_read_options(flags, read_options_of_file(options, index, input_count(flags)));
  return has_in_memory_inputs(flags) ? flags.host->inputs[index](file_options)
                                     : acquire::open_measurement(flags.paths[index], file_options);
}

Measurements open_measurements(const ReadFlags& given) {
  const OrderedFiles found = found_in_order(given);
  const ReadFlags& flags = found.flags;
  require_files(flags);
  const acquire::ReadOptions options = resolved_read_options(flags);
  const auto fork_server = fork_server_for(flags, options);
  auto all = for_each_file<std::variant<acquire::Record, acquire::FrfRecord>>(
      found, fork_server != nullptr, [&](std::size_t i) {
        if (fork_server == nullptr) return open_measurement_at(flags, options, i);
        return acquire::open_measurement_forked(fork_server, flags.paths[i], frf_read_options(flags, options));
      });
  const std::optional<Message> left_out = left_out_note(found, all);
  Measurements out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i]) continue;
    std::visit([&](auto& one) { add_notes(found, left_out, one); }, *all[i]);
    if (auto* record = std::get_if<acquire::Record>(&*all[i])) out.records.push_back(std::move(*record));
    if (auto* frfs = std::get_if<acquire::FrfRecord>(&*all[i])) out.frfs.push_back(std::move(*frfs));
    if (out.records.empty() || out.frfs.empty()) continue;
    throw InputError("records and FRFs cannot be joined",
                     has_in_memory_inputs(flags) ? "data in memory" : flags.paths[i],
                     "analyse the two kinds separately");
  }
  if (flags.frf_kind && !out.records.empty()) {
    throw OptionError({"frf_kind"},
                      "cannot be set for a record of force and acceleration: it is the kind of the FRFs in a file",
                      "leave it out");
  }
  if (flags.averages && !out.records.empty()) {
    throw OptionError(
        {"averages"},
        "cannot be set for a record of force and acceleration: it is the number of averages of the FRFs in a file",
        "leave it out");
  }
  return out;
}

acquire::FrfRecord join_frfs_of(const ReadFlags& flags, std::vector<acquire::FrfRecord> frfs) {
  if (frfs.size() > 1 && flags.files == acquire::FileGrouping::hits)
    throw OptionError({"files"}, "cannot be 'hits' for FRFs, which hold no hits", "give points or tests");
  return acquire::join_frfs(std::move(frfs));
}

std::vector<acquire::Record> open_records(const ReadFlags& given) {
  const OrderedFiles found = found_in_order(given);
  const ReadFlags& flags = found.flags;
  require_files(flags);
  const acquire::ReadOptions options = resolved_read_options(flags);
  auto all =
      for_each_file<acquire::Record>(found, false, [&](std::size_t i) { return open_record_at(flags, options, i); });
  std::vector<acquire::Record> records;
  records.reserve(all.size());
  const std::optional<Message> left_out = left_out_note(found, all);
  for (auto& record : all) {
    if (!record) continue;
    records.push_back(std::move(*record));
    add_notes(found, left_out, records.back());
  }
  return records;
}

}  // namespace percuss::tools
