#include <cmath>
#include <memory>

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
  const char* const option = crossings ? "--gate-times-s" : "--period-s";
  if (!period.problem.empty())
    throw UsageError(std::string(option) + ": " + period.problem, "give the times in the order of the crossings");
  if (!(period.period_s > 0)) throw UsageError(std::string(option) + ": no period above 0", "give seconds");
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
  const auto both = [](bool a, bool b, const char* options) {
    if (a && b) throw UsageError(std::string(options) + " are both given", "leave one of them");
  };
  both(!f.periods_s.empty(), !f.crossings_s.empty(), "--period-s and --gate-times-s");
  both(f.moi_ozin2.has_value(), !f.periods_s.empty() || !f.crossings_s.empty(), "--moi-oz-in2 and a period");
  both(f.besr.has_value(), f.bbcor.has_value(), "--besr and --bbcor");
  both(f.besr || f.bbcor, f.in_mph && f.out_mph, "speeds and --besr or --bbcor");
  if (f.rings_in.size() > kRings)
    throw UsageError("--diameter-in: more than 7 rings", "give those 3 to 9 in from the tip");
}

void require_room(const MetricsFlags& f) {
  constexpr double kPivot_in = 6;
  const double length_in = f.length_in.value_or(2 * kPivot_in + 1e6);
  if (!(length_in > 2 * kPivot_in)) throw UsageError("--length-in: no bat is so short", "give more than 12 in");
  if (f.z_in && *f.z_in > length_in - kPivot_in)
    throw UsageError("--z-in lies behind the pivot", "give inches from the barrel's tip");
  if (f.cg_in && *f.cg_in > length_in - kPivot_in)
    throw UsageError("--cg-in lies behind the pivot", "give inches from the barrel's tip");
}

int metrics(const MetricsFlags& flags) {
  check_outputs(flags.output, {".json", ".csv", ".html"});
  require_one_source(flags);
  require_room(flags);
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
  const std::string before = command.heading("Readings");
  command.value("--length-in", f.length_in, "Length of the bat").above_zero().type("IN");
  command.value("--weight-oz", f.weight_oz, "Weight of the bat").above_zero().type("OZ");
  command.value("--cg-in", f.cg_in, "Balance point, from the barrel's tip").not_negative().type("IN");
  command.list("--period-s", f.periods_s, "Period of the bat swinging about the pivot, or several readings of it")
      .above_zero()
      .type("S,...");
  command.list("--gate-times-s", f.crossings_s, "Times at which the swinging bat crossed the light gate").type("S,...");
  command
      .value("--crossings-per-period", f.crossings_per_period,
             "How often the bat crosses the gate in a period: 2 there and back, 1 one way")
      .within(1, 2)
      .type("1|2")
      .show_default();
  command.value("--moi-oz-in2", f.moi_ozin2, "Moment of inertia about the pivot, where it is known")
      .above_zero()
      .type("OZIN2");
  command.value("--ball-g", f.ball_g, "Mass of the ball").above_zero().type("G");
  command.value("--z-in", f.z_in, "Where the ball hits, from the barrel's tip").not_negative().type("IN");
  command.value("--v-in-mph", f.in_mph, "Speed of the ball before").above_zero().type("MPH");
  command.value("--v-out-mph", f.out_mph, "Speed of the ball after, back where it came from").finite().type("MPH");
  command.value("--besr", f.besr, "BESR, in place of the speeds").finite();
  command.value("--bbcor", f.bbcor, "BBCOR, in place of the speeds").finite();
  command.value("--v-swing-mph", f.swing_mph, "Speed of the swing at the impact, in place of the swing model's")
      .above_zero()
      .type("MPH");
  command.list("--diameter-in", f.rings_in, "Barrel diameters 3, 4, ... 9 in from the tip").above_zero().type("IN,...");
  command.value("--handle-diameter-in", f.handle_in, "Diameter of the handle 6 in from the knob")
      .above_zero()
      .type("IN");
  command.heading(before);
}

void add_resolutions(Command& command, MetricsFlags& f) {
  const std::string before = command.heading("Resolution of the readings (their error: a step over the root of 12)");
  command.value("--length-resolution-in", f.steps.length_in, "Of the length").not_negative().type("IN").show_default();
  command.value("--weight-resolution-oz", f.steps.weight_oz, "Of the weight").not_negative().type("OZ").show_default();
  command.value("--cg-resolution-in", f.steps.cg_in, "Of the balance point").not_negative().type("IN").show_default();
  command.value("--ball-resolution-g", f.steps.ball_g, "Of the ball's mass").not_negative().type("G").show_default();
  command.value("--diameter-resolution-in", f.steps.diameter_in, "Of diameters")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--period-resolution-s", f.period_step_s, "Of periods or gate times; 0: not known")
      .not_negative()
      .type("S")
      .show_default();
  command.value("--moi-resolution-oz-in2", f.moi_step_ozin2, "Of the moment of inertia; 0: not known")
      .not_negative()
      .type("OZIN2")
      .show_default();
  command.value("--z-resolution-in", f.z_step_in, "Of the impact's place; 0: not known")
      .not_negative()
      .type("IN")
      .show_default();
  command.value("--speed-resolution-mph", f.speed_step_mph, "Of speeds; 0: not known")
      .not_negative()
      .type("MPH")
      .show_default();
  command.flag("--round", f.rounded, "Compute with the readings as the protocol records them, rounded to these steps");
  command.heading(before);
}

void add_constants(Command& command, MetricsFlags& f) {
  const std::string before = command.heading("Constants");
  command.value("--v-pitch-mph", f.pitch_mph, "Speed of the pitch at the plate")
      .not_negative()
      .type("MPH")
      .show_default();
  command.value("--nominal-mph", f.nominal_mph, "Speed to which NCAA BESR refers")
      .above_zero()
      .type("MPH")
      .show_default();
  command.value("--v0-mph", f.v0_mph, "Swing model: speed of the standard bat").above_zero().type("MPH").show_default();
  command.value("--swing-length-in", f.swing_length_in, "Swing model: length of the standard bat")
      .above_zero()
      .type("IN")
      .show_default();
  command.value("--swing-moi-oz-in2", f.swing_moi_ozin2, "Swing model: moment of inertia of the standard bat")
      .above_zero()
      .type("OZIN2")
      .show_default();
  command.value("--swing-exponent", f.readings.swing.exponent, "Swing model: how inertia slows the swing")
      .finite()
      .show_default();
  command.value("--lot-correction", f.readings.lot_correction, "Correction of the ball lot, added to v_out/v_in")
      .finite()
      .show_default();
  command
      .value("--gravity-in-s2", f.gravity_inps2,
             "Acceleration of gravity, as the protocol prints it; 386.089 is standard")
      .above_zero()
      .type("IN/S2")
      .show_default();
  command.heading(before);
}

}  // namespace

void add_metrics(CommandLine& line) {
  auto flags = line.values<MetricsFlags>();
  Command command = line.command("metrics", "A bat's performance in numbers: drop, MOI, BESR, BBS, BBCOR and the rest",
                                 [flags] { return metrics(*flags); });
  command.about(
      "Computes what the readings given allow and leaves out the rest: drop, moment of inertia, swing and contact "
      "speed, BESR, BBS and BBCOR, each with the uncertainty that follows from the resolution of the readings. Units "
      "are those of the test laboratory and stand in the options' names; cg and z count from the barrel's tip, the "
      "pivot is 6 in from the knob.");
  command.example(
      "percuss metrics --length-in 34 --moi-oz-in2 10450 --ball-g 145.4 --z-in 6 --v-in-mph 136 --v-out-mph 31",
      "A bat whose inertia is known, and one shot at it");
  command.example("percuss metrics --length-in 33 --weight-oz 30 --cg-in 20 --period-s 1.25,1.26",
                  "Drop and inertia from scale, balance and pendulum");
  add_readings(command, *flags);
  add_resolutions(command, *flags);
  add_constants(command, *flags);
  add_output_flags(command, flags->output, ".json, .csv, .html");
}

}  // namespace percuss::tools
