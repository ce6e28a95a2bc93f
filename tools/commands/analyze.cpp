#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/option_error.hpp"
#include "cli/option_names.hpp"
#include "cli/progress.hpp"
#include "cli/report_output.hpp"
#include "commands/analyze_outputs.hpp"
#include "commands/analyze_responses.hpp"
#include "commands/bat_label.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "report/json/analysis_json.hpp"
#include "report/svg/analysis_charts.hpp"
#include "report/text/analysis_text.hpp"
#include "report/text/skipped_work_text.hpp"

namespace percuss::tools {
namespace {

pipeline::ImpactTest deflection_of(const pipeline::Analysis& analysis) {
  if (analysis.given_frfs() != nullptr)
    throw OptionError({}, "FRFs hold no deflection over time", "give the record of force and acceleration");
  return pipeline::deflect(analysis);
}

int analyze(const AnalyzeFlags& flags) {
  const ThreadLimit limit(flags.analysis.threads);
  check_analyze_outputs(flags);
  const auto sections = flags.only.empty() ? report::default_sections() : report::parse_report_sections(flags.only);
  const bool wants_json = flags.output.json || !flags.compared.empty() ||
                          std::any_of(flags.modes_paths.begin(), flags.modes_paths.end(), is_json) ||
                          std::any_of(flags.output.paths.begin(), flags.output.paths.end(), is_json);
  if (flags.stabilisation && !wants_json) {
    throw OptionError({"stabilisation"}, "needs a JSON document to be written in", "print one, or write a .json file",
                      {"json", "output"});
  }
  const std::optional<report::BatLabel> bat = bat_label(flags.bat_id, flags.bat);
  Measurements opened = open_measurements(flags.read);
  const auto lacks_force = [](const acquire::Record& record) { return !record.has_force; };
  const auto without = std::find_if(opened.records.begin(), opened.records.end(), lacks_force);
  if (without != opened.records.end()) {
    if (!std::all_of(opened.records.begin(), opened.records.end(), lacks_force)) {
      throw InputError("no force where another file has one", without->source(),
                       "analyse files with a force and files without one separately");
    }
    return analyze_responses(flags, std::move(opened.records), bat);
  }
  Progress progress("analysing", flags.output.quiet);
  auto tests = tests_of(flags, std::move(opened));
  require_one_test(flags, sections, tests.size());
  compute(tests, sections);
  if (sections.contains(report::ReportSection::deflection))
    tests.front().deflection = deflection_of(*tests.front().analysis);
  const auto made = std::make_shared<AnalyzeResults>(
      AnalyzeResults{.flags = flags, .tests = std::move(tests), .sections = sections, .bat = bat});
  if (wants_json) made->document = document_of_tests(*made);
  if (!flags.compared.empty())
    made->comparison = comparison_of(flags, made->document, made->tests.front().analysis->record().source());
  const std::shared_ptr<const AnalyzeResults> results = made;
  const std::string text = flags.output.json ? ""
                                             : text_of(*results, {.width = terminal_width(),
                                                                  .warnings = !flags.output.quiet,
                                                                  .sketch = can_plot_in_terminal(),
                                                                  .write_option = flag_of});
  progress.stop();
  write_outputs(flags, *results);
  print(flags.output, flags.output.json ? results->document : text);
  if (flags.output.host != nullptr) give_to_host(flags.output, results);
  if (flags.trace && !flags.output.json) {
    for (const Test& test : results->tests) print_trace(*test.analysis);
  }
  if (flags.explain && !flags.output.json) {
    for (const Test& test : results->tests) std::cerr << report::skipped_text(*test.analysis).text(terminal_width());
  }
  const bool possible = std::all_of(results->tests.begin(), results->tests.end(),
                                    [](const Test& test) { return test.analysis->possible(); });
  return possible ? kOk : kImpossible;
}

}  // namespace

void add_analyze(CommandLine& line) {
  auto flags = line.values<AnalyzeFlags>();
  flags->read.options.force_optional = true;
  Command command = line.command("analyze", "Identify modes from hammer tests: hits, FRFs, modes, bending or hoop",
                                 [flags] { return analyze(*flags); });
  command.about(
      "Reads records of force and acceleration, cuts them into hits and grades the hits. Averages the accepted hits to "
      "frequency response functions (FRFs) and fits the modes: frequency in Hz and damping ratio with their standard "
      "deviations, and bending or hoop. Files of FRFs are fitted directly. Records without a force, such as a "
      "microphone's, are fitted as free decays. Two accelerometers are assumed at 0° and 90° around the barrel; "
      "--angle sets other angles.");
  command.example("percuss analyze bat.h5 --band 60:3200", "Print hits and modes from 60 to 3200 Hz as tables");
  command.example("percuss analyze bat.h5 --band 60:3200 -o report.html -o modes.json",
                  "Write the same as an HTML page and as a JSON document");
  command.example("percuss analyze bat.h5 --band 60:3200 --frf bat.frf.csv --modes-file bat.modes.csv",
                  "Write FRFs and modes as tables");
  command.example("percuss analyze bat.h5 --only hits",
                  "Check the force of the hits only (fast; use it during a session)");
  command.example("percuss analyze bat.h5 --reject-hit 3 --effort quick --json",
                  "Reject the third hit, fit quickly, and print a JSON document");
  command.example("percuss analyze frfs.h5", "Fit FRFs that another program measured or computed");
  command.example("percuss analyze ping.wav", "Fit the free decay after a blow that a microphone recorded");
  add_read_flags(command, flags->read);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, {".json", ".html", ".svg", ".csv", ".h5", ".hdf5", ".mat", ".uff", ".unv"});
  const std::string previous = command.heading("Output");
  command
      .repeatable("--frf", flags->frf_paths,
                  "Write the FRFs to this file (repeatable): .csv, .h5, .hdf5, .mat, .uff, .unv (-o writes mode shapes "
                  "to .uff, and modes to NAME.modes.csv)")
      .type("FILE");
  command
      .repeatable(
          "--modes-file", flags->modes_paths,
          "Write the modes to this file (repeatable): .csv with a row per mode, point and channel; .json; .uff, .unv")
      .type("FILE");
  command.heading(previous);
  command
      .list("--only", flags->only,
            "Compute and report only these sections. hits alone: judge the hits by their force, without reading the "
            "accelerations")
      .type("SECTION,...")
      .one_of({"hits", "frf", "coherence", "modes", "classes", "deflection"});
  command.list("--picture", flags->pictures, "Draw these pictures in a .svg file")
      .type("PICTURE,...")
      .one_of(report::analysis_chart_names());
  command
      .repeatable("--compare", flags->compared,
                  "Compare with this document, which analyze, survey or model wrote with --json (repeatable)")
      .type("FILE");
  command.flag("--per-hit", flags->per_hit, "Add every mode as fitted to each hit alone");
  command.flag("--stabilisation", flags->stabilisation, "Add the poles of all model orders to the JSON document");
  command
      .value("--bat-id", flags->bat_id, "Store this id of the bat in the document; percuss study joins documents by it")
      .type("ID");
  command
      .repeatable("--bat", flags->bat, "Store a property of the bat in the document, such as length_in=33 (repeatable)")
      .type("KEY=VALUE");
  command.flag("--trace", flags->trace,
               "Report the stages that ran: calls and seconds (on standard error, or in the JSON document)");
  command.flag("--explain", flags->explain,
               "Report the work that was skipped, and the reason (on standard error, or in the JSON document)");
}

}  // namespace percuss::tools
