#include "commands/metrics_flags.hpp"

namespace percuss::tools {

void add_metrics_readings(Command& command, MetricsFlags& f) {
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
  command.list("--diameter-in", f.diameters_in, "Set the barrel diameters 3, 4, ... 9 in from the tip")
      .above_zero()
      .type("IN,...");
  command.value("--handle-diameter-in", f.handle_diameter_in, "Set the diameter of the handle 6 in from the knob")
      .above_zero()
      .type("IN");
  command.heading(previous);
}

void add_metrics_resolutions(Command& command, MetricsFlags& f) {
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

void add_metrics_constants(Command& command, MetricsFlags& f) {
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

}  // namespace percuss::tools
