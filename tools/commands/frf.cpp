#include <memory>

#include "acquire/channels/frf_unit.hpp"
#include "acquire/write_record.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/output.hpp"
#include "cli/page_output.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "commands/analyze_tests.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "report/frf_files.hpp"
#include "report/html/analysis_page.hpp"
#include "report/json/analysis_json.hpp"
#include "report/svg/analysis_charts.hpp"
#include "report/text/analysis_text.hpp"

namespace percuss::tools {
namespace {

const std::set<report::ReportSection> kShown{report::ReportSection::hits, report::ReportSection::frf,
                                             report::ReportSection::coherence};

struct FrfFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  std::string kind = "accelerance";
};

std::unique_ptr<pipeline::Analysis> analysis_of(const FrfFlags& flags) {
  Measurements opened = open_measurements(flags.read);
  const pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  if (!opened.frfs.empty())
    return std::make_unique<pipeline::Analysis>(join_frfs_of(flags.read, std::move(opened.frfs)), options);
  return std::make_unique<pipeline::Analysis>(acquire::join_records(std::move(opened.records), flags.read.files),
                                              options);
}

void check_frf_outputs(const OutputFlags& output) {
  check_outputs(output, {".csv", ".h5", ".hdf5", ".json", ".mat", ".uff", ".unv", ".svg", ".html"});
}

void write_frf_outputs(const OutputFlags& output, const pipeline::Analysis& analysis, acquire::FrfKind kind,
                       const std::string& summary) {
  OutputGroup outputs;
  for (const std::string& path : output.paths) {
    if (extension_of(path) == ".json") {
      write_file(path, summary, output.force);
    } else if (extension_of(path) == ".svg") {
      write_file(path, report::svg_document(report::analysis_charts(analysis, {}, {"magnitude", "phase", "coherence"})),
                 output.force);
    } else if (is_page(path)) {
      write_page(path, report::analysis_page(analysis, {.sections = kShown}, provenance_now(output)), output);
    } else {
      acquire::write_frfs(path, report::frf_record_of(analysis), kind, output.force);
    }
  }
  outputs.commit();
}

void give_to_host(const OutputFlags& output, const std::shared_ptr<const pipeline::Analysis>& analysis,
                  acquire::FrfKind kind) {
  CommandResult& outcome = output.host->outcome;
  outcome.analyses = {analysis};
  outcome.text = [analysis](std::size_t width, OptionWriter write_option) {
    return report::analysis_text(*analysis, {.sections = kShown, .width = width, .write_option = write_option});
  };
  if (!analysis->possible()) return;
  outcome.save = [output = captured_output(output), analysis, kind,
                  summary = outcome.document](const SaveRequest& request) {
    const OutputFlags file_flags = single_output(output, request);
    check_frf_outputs(file_flags);
    write_frf_outputs(file_flags, *analysis, kind, summary);
  };
}

int frf(const FrfFlags& flags) {
  check_frf_outputs(flags.output);
  const acquire::FrfKind kind = acquire::parse_frf_kind(flags.kind).value();
  Progress progress("averaging", flags.output.quiet);
  const std::shared_ptr<const pipeline::Analysis> shared_analysis = analysis_of(flags);
  const pipeline::Analysis& analysis = *shared_analysis;
  analysis.hits();
  if (!analysis.possible()) {
    progress.stop();
    print(flags.output, report::analysis_json(analysis, {.sections = {report::ReportSection::hits}}));
    if (flags.output.host != nullptr) give_to_host(flags.output, shared_analysis, kind);
    return kImpossible;
  }
  require_agreeing_files(flags.read, analysis);
  for (const Message& note : analysis.record().notes) print_note(flags.output, note);
  const auto summary = report::analysis_json(analysis, {.sections = kShown});
  progress.stop();
  write_frf_outputs(flags.output, analysis, kind, summary);
  if (flags.output.json) {
    print(flags.output, summary);
  } else if (flags.output.paths.empty()) {
    print(flags.output, report::frf_csv(analysis, kind));
  }
  if (flags.output.host != nullptr) give_to_host(flags.output, shared_analysis, kind);
  return kOk;
}

}  // namespace

void add_frf(CommandLine& line) {
  auto flags = line.values<FrfFlags>();
  Command command = line.command("frf", "Average FRFs and coherence", [flags] { return frf(*flags); });
  command.about(
      "Averages the accepted hits of records to frequency response functions (FRFs) and coherence, without fitting "
      "modes. Accelerance is in (m/s²)/N, mobility in (m/s)/N, receptance in m/N. The table has one row per "
      "frequency.");
  command.example("percuss frf bat.h5 --band 60:3200 -o frf.csv",
                  "Write accelerance and coherence from 60 to 3200 Hz as a table");
  command.example("percuss frf bat.h5 --band 60:3200 --kind mobility > mobility.csv",
                  "Print mobility on standard output");
  command.example("percuss frf bat.h5 --estimator hv -o frf.uff",
                  "Write a universal file, with an estimator for noise in force and acceleration");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, {".csv", ".h5", ".hdf5", ".json", ".mat", ".uff", ".unv", ".svg", ".html"});
  command.value("--kind", flags->kind, "Write FRFs of acceleration, velocity or displacement")
      .one_of({"accelerance", "mobility", "receptance"})
      .show_default();
}

}  // namespace percuss::tools
