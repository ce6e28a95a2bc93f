#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/bat_label.hpp"
#include "commands/commands.hpp"
#include "commands/metrics_flags.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "metrics/protocol/pendulum.hpp"
#include "report/metrics_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kRings = 7;
constexpr std::uint64_t kMaxReadings_bytes = std::uint64_t{16} << 20U;

std::optional<metrics::UncertainValue> reading(const std::optional<double>& value, double step, double unit,
                                               metrics::Reading which, bool rounded = false) {
  if (!value) return std::nullopt;
  return metrics::UncertainValue((rounded ? metrics::round_to_step(*value, step) : *value) * unit,
                                 metrics::reading_std(step) * unit, which);
}

std::optional<metrics::UncertainValue> period_of(const MetricsFlags& f) {
  if (f.periods_s.empty() && f.crossings_s.empty()) return std::nullopt;
  const bool crossings = !f.crossings_s.empty();
  const metrics::PeriodEstimate period =
      crossings ? metrics::period_of_crossings(f.crossings_s, f.crossings_per_period, f.period_step_s)
                : metrics::mean_period(f.periods_s, f.period_step_s);
  const OptionId option = crossings ? "gate_times_s" : "period_s";
  if (!period.problem.empty())
    throw OptionError({option}, "gives no period: " + period.problem, "give the times in the order of the crossings");
  if (!(period.period_s > 0)) throw OptionError({option}, "gives no period above 0", "give seconds");
  return metrics::UncertainValue(period.period_s, period.std_s, metrics::Reading::period);
}

metrics::BatReadings readings_of(const MetricsFlags& f) {
  metrics::BatReadings r = f.readings;
  const double mph = kMilePerHour_mps;
  r.length_m = reading(f.length_in, f.steps.length_in, kInch_m, metrics::Reading::length, f.rounded);
  r.mass_kg = reading(f.weight_oz, f.steps.weight_oz, kOunce_kg, metrics::Reading::weight, f.rounded);
  r.cg_m = reading(f.cg_in, f.steps.cg_in, kInch_m, metrics::Reading::cg, f.rounded);
  r.period_s = period_of(f);
  r.moi_kgm2 = reading(f.moi_ozin2, f.moi_step_ozin2, metrics::kOunceInch2_kgm2, metrics::Reading::moi);
  r.ball_kg = reading(f.ball_g, f.steps.ball_g, 1e-3, metrics::Reading::ball, f.rounded);
  r.z_m = reading(f.z_in, f.z_step_in, kInch_m, metrics::Reading::location);
  r.in_mps = reading(f.in_mph, f.speed_step_mph, mph, metrics::Reading::inbound);
  r.out_mps = reading(f.out_mph, f.speed_step_mph, mph, metrics::Reading::rebound);
  r.besr = reading(f.besr, 0, 1, metrics::Reading::given_besr);
  r.bbcor = reading(f.bbcor, 0, 1, metrics::Reading::given_bbcor);
  r.swing_mps = reading(f.swing_mph, f.speed_step_mph, mph, metrics::Reading::swing);
  r.pitch_mps = f.pitch_mph * mph;
  r.nominal_mps = f.nominal_mph * mph;
  r.gravity_mps2 = f.gravity_inps2 * kInch_m;
  r.swing.v0_mps = f.v0_mph * mph;
  r.swing.length_m = f.swing_length_in * kInch_m;
  r.swing.moi_kgm2 = f.swing_moi_ozin2 * metrics::kOunceInch2_kgm2;
  return r;
}

void require_one_source(const MetricsFlags& f) {
  const auto require_one = [](bool a, bool b, const std::vector<OptionId>& options) {
    if (a && b) throw OptionError(options, "exclude each other", "give one of them");
  };
  require_one(!f.periods_s.empty(), !f.crossings_s.empty(), {"period_s", "gate_times_s"});
  require_one(f.moi_ozin2.has_value(), !f.periods_s.empty(), {"moi_oz_in2", "period_s"});
  require_one(f.moi_ozin2.has_value(), !f.crossings_s.empty(), {"moi_oz_in2", "gate_times_s"});
  require_one(f.besr.has_value(), f.bbcor.has_value(), {"besr", "bbcor"});
  if ((f.besr || f.bbcor) && f.in_mph && f.out_mph) {
    throw OptionError({f.besr ? "besr" : "bbcor"}, "follows from the speeds, which are given", "omit it or the speeds",
                      {"v_in_mph", "v_out_mph"});
  }
  if (f.diameters_in.size() > kRings)
    throw OptionError({"diameter_in"}, "has more than 7 values", "give the diameters 3 to 9 in from the tip");
}

void require_positions_before_pivot(const MetricsFlags& f) {
  constexpr double kPivot_in = 6;
  const double length_in = f.length_in.value_or(2 * kPivot_in + 1e6);
  if (!(length_in > 2 * kPivot_in)) throw OptionError({"length_in"}, "is too short for a bat", "give more than 12 in");
  if (f.z_in && *f.z_in > length_in - kPivot_in)
    throw OptionError({"z_in"}, "lies behind the pivot", "give inches from the tip of the barrel");
  if (f.cg_in && *f.cg_in > length_in - kPivot_in)
    throw OptionError({"cg_in"}, "lies behind the pivot", "give inches from the tip of the barrel");
}

report::NamedMetrics named_metrics(const MetricsFlags& f, report::BatLabel label = {}) {
  require_one_source(f);
  require_positions_before_pivot(f);
  return {.label = std::move(label),
          .readings = readings_of(f),
          .profile = {.length_in = f.length_in,
                      .weight_oz = f.weight_oz,
                      .cg_in = f.cg_in,
                      .handle_diameter_in = f.handle_diameter_in,
                      .ball_g = f.ball_g,
                      .diameters_in = f.diameters_in,
                      .steps = f.steps}};
}

// The bat of a row. An error names the columns in place of options.
report::NamedMetrics metrics_of_row(const MetricsFlags& flags, const metrics::ReadingsRow& row) {
  MetricsFlags f = flags;
  static_cast<metrics::LabReadings&>(f) = row.readings;
  try {
    return named_metrics(f, {.id = row.id, .properties = row.properties});
  } catch (const OptionError& error) {
    throw InputError(fmt::format("{} {}", fmt::join(error.options(), " and "), error.problem()), row.place,
                     error.remedy());
  }
}

int metrics_of_table(const MetricsFlags& flags) {
  if (!flags.bat_id.empty() || !flags.bat.empty()) {
    throw OptionError({flags.bat_id.empty() ? "bat" : "bat_id"}, "names one bat, but a table is given",
                      "write ids and properties into the table");
  }
  std::vector<report::NamedMetrics> bats;
  const auto rows =
      metrics::parse_readings_table(read_input(flags.table, kMaxReadings_bytes).view(), input_name(flags.table), flags);
  bats.reserve(rows.size());
  for (const metrics::ReadingsRow& row : rows) bats.push_back(metrics_of_row(flags, row));
  return show_report(report::metrics_table_report(bats, csv_formulas(flags.keep_formulas)), flags.output,
                     {flags.table});
}

int metrics(const MetricsFlags& flags) {
  if (flags.example) {
    print(flags.output, metrics::readings_table_example());
    return kOk;
  }
  check_outputs(flags.output, {".json", ".csv", ".html"});
  if (!flags.table.empty()) return metrics_of_table(flags);
  if (static_cast<const metrics::LabReadings&>(flags) == metrics::LabReadings{}) {
    throw UsageError("no reading is given",
                     "give what was measured, such as length and weight, or a table of readings");
  }
  const auto label = bat_label(flags.bat_id, flags.bat);
  const report::NamedMetrics one = named_metrics(flags);
  return show_report(report::metrics_report(one.readings, one.profile, label), flags.output);
}

}  // namespace

void add_metrics(CommandLine& line) {
  auto flags = line.values<MetricsFlags>();
  Command command = line.command("metrics", "Compute a bat's performance: drop, MOI, BESR, BBS, BBCOR",
                                 [flags] { return metrics(*flags); });
  command.about(
      "Computes every metric that the given readings allow: drop, moment of inertia, swing and contact speed, BESR, "
      "BBS and BBCOR. Each has the uncertainty that follows from the resolution of the readings. The names of the "
      "options state their units. cg and z are measured from the tip of the barrel; the pivot is 6 in from the knob. A "
      "table has a row per bat, with an id and readings in columns named like the options (length_in, v_in_mph). "
      "Options give the readings that a row does not state. percuss study reads the result.");
  command.example(
      "percuss metrics --length-in 34 --moi-oz-in2 10450 --ball-g 145.4 --z-in 6 --v-in-mph 136 --v-out-mph 31",
      "Compute all metrics from a known moment of inertia and one shot");
  command.example("percuss metrics --length-in 33 --weight-oz 30 --cg-in 12.5 --period-s 1.48,1.49",
                  "Compute drop and moment of inertia from scale, balance and pendulum");
  command.example("percuss metrics --example > bats.csv; percuss metrics bats.csv -o metrics.csv",
                  "Compute the metrics of every bat of a table");
  command.argument("TABLE", flags->table, "Table of readings, a row per bat; - is standard input");
  command.flag("--example", flags->example, "Print an example table of readings");
  command
      .value("--bat-id", flags->bat_id, "Store this id of the bat in the document; percuss study joins documents by it")
      .type("ID");
  command
      .repeatable("--bat", flags->bat,
                  "Store a property of the bat in the document, such as material=wood (repeatable)")
      .type("KEY=VALUE");
  add_metrics_readings(command, *flags);
  add_metrics_resolutions(command, *flags);
  add_metrics_constants(command, *flags);
  add_output_flags(command, flags->output, {".json", ".csv", ".html"});
  add_formula_flag(command, flags->keep_formulas);
}

}  // namespace percuss::tools
