#include "commands/analyze_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/progress.hpp"
#include "cli/report_output.hpp"
#include "commands/analyze_outputs.hpp"
#include "core/io/atomic_file.hpp"
#include "pipeline/response/response_test.hpp"
#include "pipeline/run_analyses.hpp"
#include "report/csv/modes_csv.hpp"
#include "report/response_report.hpp"

namespace percuss::tools {
namespace {

void refuse_force_options(const AnalyzeFlags& flags) {
  const auto refuse = [](bool given, const char* option) {
    if (given) {
      throw OptionError({option}, "needs a force, and none was recorded", "leave it out, or name the force's channel",
                        {"force_channel"});
    }
  };
  refuse(!flags.frf_path.empty(), "frf");
  const std::string modes_kind = extension_of(flags.modes_path);
  refuse(modes_kind == ".uff" || modes_kind == ".unv", "modes_file");
  refuse(flags.analysis.estimator != "h1", "estimator");
  refuse(flags.analysis.exponential_end > 0, "exponential");
  refuse(flags.analysis.delay != "off", "delay");
  refuse(flags.analysis.trigger_N.has_value(), "trigger");
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
      throw InputError(fmt::format("there are no FRFs to write to '{}' without a force channel", path), input,
                       std::string("name the force's channel, or write ") + kReportKinds, {"force_channel"});
    }
  }
}

std::vector<pipeline::ResponseTest> tests_of(const AnalyzeFlags& flags, std::vector<acquire::Record> records) {
  const pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  if (flags.read.files != acquire::FileGrouping::tests && records.size() > 1) {
    acquire::Record joined = acquire::join_records(std::move(records), flags.read.files);
    records.clear();
    records.push_back(std::move(joined));
  }
  std::vector<pipeline::ResponseTest> tests;
  for (const acquire::Record& record : records) {
    for (auto& [run, part] : pipeline::split_runs(record))
      tests.push_back(pipeline::analyse_responses(std::move(part), options));
  }
  return tests;
}

}  // namespace

int analyze_responses(const AnalyzeFlags& flags, std::vector<acquire::Record> records,
                      const std::optional<report::BatLabel>& bat) {
  refuse_force_options(flags);
  std::vector<std::string> tables;  // of modes; the other files are a report's
  OutputFlags output = flags.output;
  if (extension_of(flags.modes_path) == ".csv") {
    tables.push_back(flags.modes_path);
  } else if (!flags.modes_path.empty()) {
    output.paths.push_back(flags.modes_path);
  }
  refuse_frf_files(output, records.front().source());
  check_report_outputs(output);
  const auto first_table = std::stable_partition(output.paths.begin(), output.paths.end(),
                                                 [](const std::string& path) { return !is_modes_table(path); });
  tables.insert(tables.end(), first_table, output.paths.end());
  output.paths.erase(first_table, output.paths.end());
  const Progress progress("fitting decays", flags.output.quiet);
  std::vector<std::string> inputs;
  for (const acquire::Record& record : records) {
    for (const acquire::InputFile& file : record.files) inputs.push_back(file.path);
  }
  const std::vector<pipeline::ResponseTest> tests = tests_of(flags, std::move(records));
  report::CommandReport report = report::response_report(tests, bat, writes_charts(output));
  if (!flags.compared.empty()) {
    report.text += "\n";
    report.text += comparison_of(flags, report.json, inputs.front()).text;
  }
  progress.stop();
  const std::string table = report::modes_csv(tests);
  OutputGroup outputs;
  for (const std::string& path : tables) write_file(path, table, output.force);
  show_report(report, output, inputs);
  outputs.commit();
  if (Host* const host = flags.output.host; host != nullptr) {
    host->outcome.save = [table, save_report = host->outcome.save](const std::string& path, bool force) {
      if (is_modes_table(path)) {
        write_file(path, table, force);
      } else {
        save_report(path, force);
      }
    };
  }
  const bool possible = std::all_of(tests.begin(), tests.end(), [](const auto& test) { return test.possible(); });
  return possible ? kOk : kImpossible;
}

}  // namespace percuss::tools
