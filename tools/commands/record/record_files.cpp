#include "commands/record/record_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "acquire/live/journal_reader.hpp"
#include "acquire/write_record.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/shell_argument.hpp"
#include "commands/record/record_resume.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::tools {
namespace {

// Creates the file and removes it, so that the errors of writing it at the end of the session occur now.
void probe(const std::string& path, bool force) { const AtomicFile unused(path, force); }

std::optional<std::size_t> blows_in(const std::string& journal) {
  try {
    const acquire::JournalReader reader(journal);
    return blow_count(session_events(reader));
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

void check_session_files(RecordFlags& flags) {
  if (flags.output.empty()) throw OptionError({"output"}, "is missing", "name the file to record, such as -o test.h5");
  check_outputs({.paths = {flags.output}, .force = flags.force}, {".h5", ".hdf5"});
  probe(flags.output, flags.force);
  if (flags.report.empty()) return;
  const bool own = !flags.resume.empty() && flags.report == flags.session_report;
  const bool force = flags.is_given("force") || own;
  check_outputs({.paths = {flags.report}, .force = force}, {".html"});
  std::error_code ignored;
  flags.replace_report = flags.is_given("force") ||
                         (own && std::filesystem::exists(std::filesystem::symlink_status(flags.report, ignored)));
  probe(flags.report, flags.replace_report);
}

std::string UnfinishedSession::content() const {
  if (!blows) return "the content of its journal";
  return fmt::format("the {} blow{} of its journal", *blows, *blows == 1 ? "" : "s");
}

UnfinishedSession find_unfinished(const RecordFlags& flags) {
  UnfinishedSession found{.journal = journal_of(flags.output), .blows = {}};
  std::error_code ignored;
  if (flags.output.empty() || !std::filesystem::exists(found.journal, ignored)) return {};
  found.blows = blows_in(found.journal);
  if (flags.force) return found;
  const std::string blows =
      found.blows ? fmt::format(" after {} blow{}", *found.blows, *found.blows == 1 ? "" : "s") : "";
  throw InputError(fmt::format("a journal exists: a session was not finished{}", blows), found.journal,
                   "resume it, or overwrite it", {"resume", "force"});
}

std::string resume_command(const std::string& output) {
  return "percuss record --resume " + shell_quoted_argument(output);
}

void write_session(const RecordFlags& flags, const acquire::Record& record) {
  try {
    acquire::write_record(flags.output, record, flags.force);
  } catch (const InputError& error) {
    std::error_code ignored;
    const auto found = std::filesystem::symlink_status(flags.output, ignored);
    const bool in_the_way = std::filesystem::exists(found) && !(flags.force && std::filesystem::is_regular_file(found));
    throw InputError(
        error.problem(), error.where(),
        fmt::format("the blows are safe in the journal: {}, then type {}",
                    in_the_way ? "move this elsewhere" : "remove the cause", resume_command(flags.output)));
  }
}

}  // namespace percuss::tools
