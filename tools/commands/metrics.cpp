#include <cmath>
#include <memory>

#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "core/error.hpp"
#include "metrics/protocol/pendulum.hpp"
#include "report/metrics_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kRings = 7;

struct MetricsFlags {
  std::optional<double> length_in, weight_oz, cg_in, moi_ozin2, ball_g, z_in, in_mph, out_mph, besr, bbcor, swing_mph;
  std::optional<double> handle_in;
  std::vector<double> rings_in, periods_s, crossings_s;
  std::size_t crossings_per_period = 2;
  metrics::ProtocolSteps steps;
  double period_step_s = 0, moi_step_ozin2 = 0, z_step_in = 0, speed_step_mph = 0;
  double v0_mph = 60, pitch_mph = 70, nominal_mph = 136, swing_length_in = 28, swing_moi_ozin2 = 15000;
  double gravity_inps2 = 386.4;
  metrics::BatReadings readings;
  bool rounded = false;
  OutputFlags output;
};

std::optional<metrics::UncertainValue> reading(const std::optional<double>& value, double step, double unit,
                                               metrics::Reading which, bool rounded = false) {
  if (!value) return std::nullopt;
  return metrics::UncertainValue((rounded ? metrics::recorded(*value, step) : *value) * unit,
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
  if (f.rings_in.size() > kRings)
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

int metrics(const MetricsFlags& flags) {
  check_outputs(flags.output, {".json", ".csv", ".html"});
  require_one_source(flags);
  require_positions_before_pivot(flags);
  const report::BatProfileReadings profile{.length_in = flags.length_in,
                                           .weight_oz = flags.weight_oz,
                                           .cg_in = flags.cg_in,
                                           .handle_in = flags.handle_in,
                                           .ball_g = flags.ball_g,
                                           .rings_in = flags.rings_in,
                                           .steps = flags.steps};
  return show_report(report::metrics_report(readings_of(flags), profile), flags.output);
}

void add_readings(Command& command, MetricsFlags& f) {
  const std::string previous = command.heading("Readings");
  command.value("--length-in", f.length_in, "Set the length of the bat").above_zero().type("IN");
  command.value("--weight-oz", f.weight_oz, "Set the weight of the bat").above_zero().type("OZ");
  command.value("--cg-in", f.cg_in, "Set the balance point, from the tip of the barrel").not_negative().type("IN");
  command.list("--period-s", f.periods_s, "Set the period of the bat swinging about the pivot; one reading or several")
      .above_zero()
      .type("S,...");
  command.list("--gate-times-s", f.crossings_s, "Set the times at which the swinging bat crosses the light gate")
      .type("S,...");
  command
      .value("--crossings-per-period", f.crossings_per_period,
             "Set the crossings of the gate per period: 2 if the gate counts both directions, 1 if it counts one")
      .within(1, 2)
      .type("1|2")
      .show_default();
  command.value("--moi-oz-in2", f.moi_ozin2, "Set the moment of inertia about the pivot, if known")
      .above_zero()
      .type("OZIN2");
  command.value("--ball-g", f.ball_g, "Set the mass of the ball").above_zero().type("G");
  command.value("--z-in", f.z_in, "Set the impact position, from the tip of the barrel").not_negative().type("IN");
  command.value("--v-in-mph", f.in_mph, "Set the speed of the ball before the impact").above_zero().type("MPH");
  command.value("--v-out-mph", f.out_mph, "Set the rebound speed of the ball, positive away from the bat")
      .finite()
      .type("MPH");
  command.value("--besr", f.besr, "Set BESR in place of the speeds").finite();
  command.value("--bbcor", f.bbcor, "Set BBCOR in place of the speeds").finite();
  command
      .value("--v-swing-mph", f.swing_mph, "Set the swing speed at the impact position, in place of the swing model's")
      .above_zero()
      .type("MPH");
  command.list("--diameter-in", f.rings_in, "Set the barrel diameters 3, 4, ... 9 in from the tip")
      .above_zero()
      .type("IN,...");
  command.value("--handle-diameter-in", f.handle_in, "Set the diameter of the handle 6 in from the knob")
      .above_zero()
      .type("IN");
  command.heading(previous);
}

void add_resolutions(Command& command, MetricsFlags& f) {
  const std::string previous =
      command.heading("Resolution of the readings (standard deviation: the resolution divided by √12)");
  command.value("--length-resolution-in", f.steps.length_in, "Set the resolution of the length")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--weight-resolution-oz", f.steps.weight_oz, "Set the resolution of the weight")
      .not_negative()
      .type("OZ")
      .show_default();
  command.value("--cg-resolution-in", f.steps.cg_in, "Set the resolution of the balance point")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--ball-resolution-g", f.steps.ball_g, "Set the resolution of the ball's mass")
      .not_negative()
      .type("G")
      .show_default();
  command.value("--diameter-resolution-in", f.steps.diameter_in, "Set the resolution of diameters")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--period-resolution-s", f.period_step_s, "Set the resolution of periods or gate times; 0: unknown")
      .not_negative()
      .type("S")
      .show_default();
  command.value("--moi-resolution-oz-in2", f.moi_step_ozin2, "Set the resolution of the moment of inertia; 0: unknown")
      .not_negative()
      .type("OZIN2")
      .show_default();
  command.value("--z-resolution-in", f.z_step_in, "Set the resolution of the impact position; 0: unknown")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--speed-resolution-mph", f.speed_step_mph, "Set the resolution of speeds; 0: unknown")
      .not_negative()
      .type("MPH")
      .show_default();
  command.flag("--round", f.rounded, "Round the readings to these resolutions, as the protocol records them");
  command.heading(previous);
}

void add_constants(Command& command, MetricsFlags& f) {
  const std::string previous = command.heading("Constants");
  command.value("--v-pitch-mph", f.pitch_mph, "Set the speed of the pitch at the plate")
      .not_negative()
      .type("MPH")
      .show_default();
  command.value("--nominal-mph", f.nominal_mph, "Set the reference speed of NCAA BESR")
      .above_zero()
      .type("MPH")
      .show_default();
  command.value("--v0-mph", f.v0_mph, "Set the speed of the standard bat in the swing model")
      .above_zero()
      .type("MPH")
      .show_default();
  command
      .value("--swing-length-in", f.swing_length_in,
             "Set the distance from the knob at which the standard bat has the speed --v0-mph")
      .above_zero()
      .type("IN")
      .show_default();
  command
      .value("--swing-moi-oz-in2", f.swing_moi_ozin2,
             "Set the moment of inertia of the standard bat in the swing model")
      .above_zero()
      .type("OZIN2")
      .show_default();
  command.value("--swing-exponent", f.readings.swing.exponent, "Set the exponent of inertia in the swing model")
      .finite()
      .show_default();
  command
      .value("--lot-correction", f.readings.lot_correction, "Set the correction of the ball lot, added to v_out/v_in")
      .finite()
      .show_default();
  command
      .value("--gravity-in-s2", f.gravity_inps2,
             "Set the acceleration of gravity, as printed in the protocol; standard gravity is 386.089")
      .above_zero()
      .type("IN/S2")
      .show_default();
  command.heading(previous);
}

}  // namespace

void add_metrics(CommandLine& line) {
  auto flags = line.values<MetricsFlags>();
  Command command = line.command("metrics", "Compute a bat's performance: drop, MOI, BESR, BBS, BBCOR",
                                 [flags] { return metrics(*flags); });
  command.about(
      "Computes every metric that the given readings allow: drop, moment of inertia, swing and contact speed, BESR, "
      "BBS and BBCOR. Each has the uncertainty that follows from the resolution of the readings. The names of the "
      "options state their units. cg and z are measured from the tip of the barrel; the pivot is 6 in from the knob.");
  command.example(
      "percuss metrics --length-in 34 --moi-oz-in2 10450 --ball-g 145.4 --z-in 6 --v-in-mph 136 --v-out-mph 31",
      "Compute all metrics from a known moment of inertia and one shot");
  command.example("percuss metrics --length-in 33 --weight-oz 30 --cg-in 12.5 --period-s 1.48,1.49",
                  "Compute drop and moment of inertia from scale, balance and pendulum");
  add_readings(command, *flags);
  add_resolutions(command, *flags);
  add_constants(command, *flags);
  add_output_flags(command, flags->output, ".json, .csv, .html");
}

}  // namespace percuss::tools
