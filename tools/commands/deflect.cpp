#include <memory>
#include <utility>
#include <vector>

#include "acquire/format_registry.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/open_files.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "commands/deflect_comparison.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/impacts.hpp"
#include "report/deflection_report.hpp"
#include "report/svg/deflection_chart.hpp"

namespace percuss::tools {
namespace {

struct DeflectFlags {
  ReadFlags read;
  AnalysisFlags analysis;
  OutputFlags output;
  pipeline::ImpactTestOptions options;
  std::string method = "auto", positions;
  ComparisonFlags comparison;
};

metrics::DeflectionMethod method_named(const std::string& name) {
  for (const metrics::DeflectionMethod method :
       {metrics::DeflectionMethod::small_interval, metrics::DeflectionMethod::drift_free,
        metrics::DeflectionMethod::frequency, metrics::DeflectionMethod::modal}) {
    if (name == name_of(method)) return method;
  }
  return metrics::DeflectionMethod::automatic;
}

std::unique_ptr<pipeline::Analysis> analysis_of(const DeflectFlags& flags) {
  if (flags.read.files == acquire::FileGrouping::tests) {
    throw OptionError::wrong_value("files", "tests", "give hits or points, or one test at a time",
                                   "deflect takes one test");
  }
  ReadFlags read = flags.read;
  read.options.force_optional = true;
  const pipeline::AnalysisOptions options = analysis_options(flags.analysis);
  auto analysis = std::make_unique<pipeline::Analysis>(acquire::join_records(open_records(read), read.files), options);
  if (auto without_force = pipeline::record_without_idle_force(*analysis))
    analysis = std::make_unique<pipeline::Analysis>(*std::move(without_force), options);
  return analysis;
}

void check_deflection_outputs(const OutputFlags& output) {
  check_outputs(output, {".json", ".csv", ".h5", ".hdf5", ".svg", ".html"});
}

// Deflection over time; then the comparison with a model or another test, or else deflection over position.
void add_charts(report::CommandReport& report, const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  std::vector<report::LineChart> compared = std::move(report.charts);
  report.charts = {report::deflection_chart(analysis, test)};
  if (!compared.empty()) {
    report.charts.insert(report.charts.end(), compared.begin(), compared.end());
  } else if (auto positions = report::deflection_over_position(analysis, test)) {
    report.charts.push_back(std::move(*positions));
  }
}

void write_deflection(const OutputFlags& output, report::CommandReport report, const pipeline::Analysis& analysis,
                      const pipeline::ImpactTest& test) {
  if (writes_charts(output)) add_charts(report, analysis, test);
  OutputGroup outputs;
  for (const std::string& path : output.paths) {
    const std::string kind = extension_of(path);
    if (acquire::writes_hdf5(path) && !test.hits.empty()) {
      report::write_deflection_hdf5(path, analysis, test, output.force);
    } else if (kind == ".csv") {
      write_file(path, report::deflection_csv(analysis, test), output.force);
    } else if (!acquire::writes_hdf5(path)) {
      write_report(path, report, inputs_of(analysis), output);
    }
  }
  outputs.commit();
}

int deflect_files(const DeflectFlags& flags) {
  check_deflection_outputs(flags.output);
  pipeline::ImpactTestOptions options = flags.options;
  options.deflection.method = method_named(flags.method);
  if (!flags.positions.empty())
    options.position_m = parse_range("positions", flags.positions, RangeForm::single_value_allowed, "M").values();
  Progress progress("integrating", flags.output.quiet);
  const std::shared_ptr<const pipeline::Analysis> shared_analysis = analysis_of(flags);
  const auto deflected = std::make_shared<const pipeline::ImpactTest>(pipeline::deflect(*shared_analysis, options));
  const pipeline::Analysis& analysis = *shared_analysis;
  const pipeline::ImpactTest& test = *deflected;
  progress.stop();
  report::CommandReport report;
  report.json = report::deflection_json(analysis, test);
  report.text = report::deflection_text(analysis, test);
  if (flags.comparison.wanted()) {
    const ImpactModes modes = modes_of_impacts(analysis);
    const report::CommandReport compared =
        impact_comparison(flags.comparison, flags.output.host, analysis, test, modes);
    report.json = report::with_comparison(report.json, modes.modes, compared.json);
    report.text += std::string("\n");
    report.text += compared.text;
    report.charts = compared.charts;
  }
  write_deflection(flags.output, report, analysis, test);
  print_report(report, flags.output);
  if (flags.output.host != nullptr) {
    CommandResult& outcome = flags.output.host->outcome;
    outcome.analyses = {shared_analysis};
    outcome.deflection = deflected;
    outcome.save = [output = captured_output(flags.output), report, shared_analysis,
                    deflected](const SaveRequest& request) {
      const OutputFlags file_flags = single_output(output, request);
      check_deflection_outputs(file_flags);
      write_deflection(file_flags, report, *shared_analysis, *deflected);
    };
  }
  return test.hits.empty() ? kImpossible : kOk;
}

void add_comparison_options(Command& command, DeflectFlags& flags) {
  command
      .repeatable("--compare", flags.comparison.compared,
                  "Compare modes and deflections with this document, which analyze or model wrote with --json "
                  "(repeatable)")
      .type("FILE");
  command
      .list("--beam", flags.comparison.beam,
            "Compare modes and deflections with this beam of percuss model: ei, rho_a, torsion, length, support, "
            "ball_mass, speed, hertz")
      .type("KEY=VALUE,...");
}

}  // namespace

void add_deflect(CommandLine& line) {
  auto flags = line.values<DeflectFlags>();
  Command command =
      line.command("deflect", "Compute the deflection under an impact from the acceleration at the struck point",
                   [flags] { return deflect_files(*flags); });
  command.about(
      "Integrates the acceleration of the struck point twice, without the drift of plain sums. Reports the largest "
      "deflection of each hit in m with its standard deviation. Files (.csv, .h5) hold the curves over time.");
  command.example("percuss deflect bat.h5 --highpass-corner 1", "Undo the 1 Hz high-pass of the charge amplifier");
  command.example("percuss deflect bat.h5 --method drift-free -o deflection.csv",
                  "Write the curves over time as a table");
  command.example("percuss deflect bat.h5 --beam ei=4000,speed=5 --compare test.json",
                  "Compare frequencies and deflections of this test, a model beam and another test");
  metrics::DeflectionOptions& deflection = flags->options.deflection;
  command
      .value("--method", flags->method,
             "Choose the method. auto: integrate without drift if the record shows the structure at rest before the "
             "impact, otherwise use modes and force if they are known")
      .one_of({"auto", "small-interval", "drift-free", "frequency", "modal"})
      .show_default();
  command
      .value("--highpass-corner", deflection.highpass_corner_Hz,
             "Undo the first-order high-pass of the charge amplifier with this corner frequency; 0: none")
      .not_negative()
      .type("HZ");
  command.value("--lowest", deflection.lowest_Hz, "Omit frequencies below this; for --method frequency")
      .above_zero()
      .type("HZ");
  command.flag("--free-body", deflection.free_body,
               "State that the structure may move away from its rest position: it hangs on rubber bands or strings, or "
               "nothing holds it");
  command
      .value(
          "--effective-mass", flags->options.effective_mass_kg,
          "State that nothing pulls the structure back within the record, and its effective mass at the struck point: "
          "1/(1/m + d^2/J), with the mass m, the moment of inertia J about the centre of mass, and the distance d of "
          "the blow from it. Its rigid-body motion then follows from the force")
      .above_zero()
      .type("KG");
  command.value("--positions", flags->positions, "Set the positions of the points along the structure in m, in order")
      .type("LO:STEP:HI");
  command
      .value("--beam-distance", flags->options.beam_distance_m,
             "Set the distance from the light beam to the structure; gives the speed of the ball")
      .above_zero()
      .type("M");
  command
      .value("--beam-time", flags->options.beam_time_s,
             "Set the time at which the ball crosses the light beam, from the start of the record")
      .finite()
      .type("S");
  add_comparison_options(command, *flags);
  add_read_flags(command, flags->read, Reads::records);
  add_analysis_flags(command, flags->analysis);
  add_output_flags(command, flags->output, {".json", ".csv", ".h5", ".hdf5", ".svg", ".html"});
}

}  // namespace percuss::tools
