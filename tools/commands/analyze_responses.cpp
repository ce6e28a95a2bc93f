#include "commands/analyze_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/progress.hpp"
#include "cli/report_output.hpp"
#include "commands/analyze_outputs.hpp"
#include "core/io/atomic_file.hpp"
#include "pipeline/response/response_files.hpp"
#include "pipeline/response/response_test.hpp"
#include "report/csv/modes_csv.hpp"
#include "report/response_report.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::tools {
namespace {

void refuse_force_options(const AnalyzeFlags& flags) {
  const auto refuse = [](bool given, const OptionId& option) {
    if (given) {
      throw OptionError({option}, "needs a force, and none was recorded", "leave it out, or name the force's channel",
                        {"force_channel"});
    }
  };
  refuse(!flags.frf_paths.empty(), "frf");
  refuse(std::any_of(flags.modes_paths.begin(), flags.modes_paths.end(), is_uff), "modes_file");
  for (const OptionId& option : pipeline::stated_force_options(analysis_options(flags.analysis))) refuse(true, option);
  refuse(flags.per_hit, "per_hit");
  refuse(flags.stabilisation, "stabilisation");
  refuse(flags.trace, "trace");
  refuse(flags.explain, "explain");
  for (const std::string& section : flags.only) {
    if (section == "frf" || section == "coherence" || section == "deflection") {
      throw OptionError::wrong_value("only", section, "leave it out, or name the force's channel",
                                     "it needs a force, and none was recorded");
    }
  }
}

void refuse_frf_files(const OutputFlags& output, const std::string& input) {
  constexpr std::array kFrfs = {".h5", ".hdf5", ".mat", ".uff", ".unv"};
  for (const std::string& path : output.paths) {
    if (std::find(kFrfs.begin(), kFrfs.end(), extension_of(path)) != kFrfs.end()) {
      throw InputError(
          fmt::format("without a force channel there are neither FRFs nor residues to write to '{}'", path), input,
          fmt::format("name the force's channel, or write {}", fmt::join(report_extensions(), ", ")),
          {"force_channel"});
    }
  }
}

using Sections = std::set<report::ReportSection>;

// Whether modes are needed: by a section, or by a table or a picture of modes, whatever the sections are.
pipeline::ResponseWork work_of(const AnalyzeFlags& flags, const Sections& sections) {
  const auto shows_modes = [](const std::string& path) {
    return extension_of(path) == ".csv" || extension_of(path) == ".svg";
  };
  const bool modes = sections.contains(report::ReportSection::modes) ||
                     sections.contains(report::ReportSection::classes) || !flags.modes_paths.empty() ||
                     std::any_of(flags.output.paths.begin(), flags.output.paths.end(), shows_modes);
  return modes ? pipeline::ResponseWork::modes : pipeline::ResponseWork::hits;
}

std::vector<pipeline::ResponseTest> tests_of(const AnalyzeFlags& flags, std::vector<acquire::Record> records,
                                             pipeline::ResponseWork work) {
  using acquire::FileGrouping;
  const pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  if (flags.read.files == FileGrouping::automatic && work == pipeline::ResponseWork::modes)
    return pipeline::tests_of_files(records, options);
  if (flags.read.files != FileGrouping::tests && records.size() > 1) {
    acquire::Record joined = acquire::join_records(std::move(records), flags.read.files);
    records.clear();
    records.push_back(std::move(joined));
  }
  return pipeline::tests_of_records(records, options, work);
}

using SharedTests = std::shared_ptr<const std::vector<pipeline::ResponseTest>>;

bool all_possible(const std::vector<pipeline::ResponseTest>& tests) {
  return std::all_of(tests.begin(), tests.end(), [](const auto& test) { return test.possible(); });
}

void require_fitted(const std::vector<pipeline::ResponseTest>& tests, const std::string& path) {
  const std::string kind = extension_of(path);
  if (tests.front().fitted || (kind != ".csv" && kind != ".svg")) return;
  throw OptionError({"only"}, "leaves the modes out, which the file is to show", "analyse the record without it");
}

// Completes the outcome that show_report() gave: it can also save tables of modes, and states the number of tests.
void complete_outcome(CommandResult& outcome, const SharedTests& tests) {
  outcome.save = [tests, save_report = outcome.save](const SaveRequest& request) {
    require_fitted(*tests, request.path);
    if (is_csv_of_modes(request.path)) {
      write_file(request.path, report::modes_csv(*tests), request.force);
    } else {
      save_report(request);
    }
  };
  outcome.tests = tests->size();
  outcome.possible = all_possible(*tests);
}

CommandResult outcome_of_test(const pipeline::ResponseTest& test, const report::ResponseReportOptions& options,
                              OutputFlags output) {
  Host host;
  host.equivalent_command = output.equivalent_command;
  output.host = &host;
  output.paths.clear();
  const auto tests = std::make_shared<const std::vector<pipeline::ResponseTest>>(1, test);
  std::vector<std::string> inputs;
  for (const acquire::InputFile& file : test.record.files) inputs.push_back(file.path);
  show_report(report::response_report(*tests, options), output, inputs);
  complete_outcome(host.outcome, tests);
  return std::move(host.outcome);
}

}  // namespace

int analyze_responses(const AnalyzeFlags& flags, std::vector<acquire::Record> records,
                      const std::optional<report::BatLabel>& bat) {
  refuse_force_options(flags);
  const Sections sections = flags.only.empty() ? report::default_sections() : report::parse_report_sections(flags.only);
  std::vector<std::string> tables;  // files of modes; `output` has the files of the report
  OutputFlags output = flags.output;
  for (const std::string& path : flags.modes_paths)
    (extension_of(path) == ".csv" ? tables : output.paths).push_back(path);
  refuse_frf_files(output, records.front().source());
  check_report_outputs(output);
  const auto first_table = std::stable_partition(output.paths.begin(), output.paths.end(),
                                                 [](const std::string& path) { return !is_csv_of_modes(path); });
  tables.insert(tables.end(), first_table, output.paths.end());
  output.paths.erase(first_table, output.paths.end());
  Progress progress("fitting decays", flags.output.quiet);
  std::vector<std::string> inputs;
  for (const acquire::Record& record : records) {
    for (const acquire::InputFile& file : record.files) inputs.push_back(file.path);
  }
  const auto shared_tests = std::make_shared<const std::vector<pipeline::ResponseTest>>(
      tests_of(flags, std::move(records), work_of(flags, sections)));
  const std::vector<pipeline::ResponseTest>& tests = *shared_tests;
  report::ResponseReportOptions options{.bat = bat, .charts = writes_charts(output), .sections = sections};
  report::CommandReport report = report::response_report(tests, options);
  if (!flags.compared.empty()) {
    report.text += "\n";
    report.text += comparison_of(flags, report.json, inputs.front()).text;
  }
  progress.stop();
  OutputGroup outputs;
  for (const std::string& path : tables) write_file(path, report::modes_csv(tests), output.force);
  show_report(report, output, inputs);
  outputs.commit();
  if (flags.output.host != nullptr) {
    complete_outcome(flags.output.host->outcome, shared_tests);
    options.charts = false;
    flags.output.host->outcome.of_test = [shared_tests, options, output = captured_output(output)](std::size_t test) {
      return outcome_of_test(shared_tests->at(test), options, output);
    };
  }
  return all_possible(tests) ? kOk : kImpossible;
}

}  // namespace percuss::tools
