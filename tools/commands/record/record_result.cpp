#include "commands/record/record_result.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "cli/exit_code.hpp"
#include "cli/host.hpp"
#include "cli/output.hpp"
#include "cli/shell_argument.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "report/json/analysis_json.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

// As typed into a shell.
std::string command_of(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + shell_quoted_argument(word);
  return command;
}

std::vector<std::string> analysis_words(const RecordFlags& flags, const std::string& output) {
  const bool survey = !flags.geometry.empty();
  std::vector<std::string> words{std::string("percuss"), survey ? "survey" : "analyze", flags.output};
  if (!output.empty()) words.insert(words.end(), {"-o", output});
  if (!flags.band.empty()) words.insert(words.end(), {"--band", flags.band});
  if (flags.object != "auto") words.insert(words.end(), {"--object", flags.object});
  if (survey) words.insert(words.end(), {"--geometry", flags.geometry, "--roving", flags.roving});
  return words;
}

}  // namespace

std::string analysis_command(const RecordFlags& flags) { return command_of(analysis_words(flags, {})); }

int write_session_report(const RecordFlags& flags) {
  const bool survey = !flags.geometry.empty();
  std::vector<std::string> words = analysis_words(flags, flags.report);
  const std::string later = command_of(words);
  if (flags.replace_report) words.emplace_back("--force");
  if (flags.quiet) words.emplace_back("--quiet");
  Host host;  // takes the text that the command would print
  host.equivalent_command = command_of(words);
  CommandLine line("percuss", "", report::version(), &host);
  survey ? add_survey(line) : add_analyze(line);
  std::vector<const char*> arguments;
  arguments.reserve(words.size());
  for (const std::string& word : words) arguments.push_back(word.c_str());
  int code = kBadInput;
  try {
    code = line.run(static_cast<int>(arguments.size()), arguments.data());
  } catch (const InputError& error) {
    print_note({}, {error.what(), error.options()});
  }
  if (code == kOk) return code;
  for (const Message& note : host.outcome.notes) print_note({}, note);
  print_note({}, {"the report was not written, or is not complete; to write it: " + later, {}});
  return code;
}

SessionResult::SessionResult(acquire::Record record, const std::string& path, const pipeline::AnalysisOptions& options,
                             std::size_t accepted) {
  record.files = {{.path = path, .bytes = std::filesystem::file_size(path)}};
  std::vector<acquire::Record> records;
  records.push_back(std::move(record));
  runs_ = pipeline::analyses_of_runs(std::move(records), options);
  if (accepted > 0) quality_ = pipeline::quality_of(analysis(), accepted);
}

std::size_t SessionResult::further_warnings() const {
  std::size_t further = 0;
  for (const pipeline::Warning& warning : analysis().warnings()) {
    const bool shown =
        std::any_of(quality_.problems.begin(), quality_.problems.end(),
                    [&](const pipeline::SessionProblem& problem) { return problem.code == warning.code; });
    further += warning.severity != acquire::Severity::info && !shown ? 1U : 0U;
  }
  return further;
}

std::string SessionResult::document() const {
  analysis().hits();
  if (analysis().possible()) analysis().compute_modes_and_frfs();
  return report::analysis_json({{.run = runs_.front().run, .analysis = &analysis()}});
}

}  // namespace percuss::tools
