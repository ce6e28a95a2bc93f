#include <memory>

#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "report/rigid_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kSteps = 100;  // between the default positions

struct RigidFlags {
  model::RigidCollision collision;
  double length_m = 0.84;
  std::optional<double> pivot_m;
  std::string at;
  OutputFlags output;
};

std::vector<double> positions(const RigidFlags& flags) {
  if (!flags.at.empty()) return parse_range("at", flags.at, RangeForm::several_values, "M").values();
  return Range{.low = 0, .step = flags.length_m / 2 / kSteps, .count = kSteps + 1}.values();
}

int model_rigid(const RigidFlags& flags) {
  check_report_outputs(flags.output);
  model::RigidCollision collision = flags.collision;
  if (flags.pivot_m) collision.bat_speed_mps += collision.swing_rate_radps * *flags.pivot_m;
  return show_report(report::rigid_report(collision, positions(flags)), flags.output);
}

}  // namespace

void add_model_rigid(CommandLine& line) {
  auto flags = line.values<RigidFlags>();
  Command command =
      line.command("model rigid", "Predict the exit speed of a ball from a rigid bat at each impact position",
                   [flags] { return model_rigid(*flags); });
  command.about(
      "Computes the impact of a ball on a rigid bat from conservation of momentum. Positions are in m from the centre "
      "of mass, positive towards the barrel.");
  command.example("percuss model rigid --swing-rate 50", "Compute exit speeds along the bat at 50 rad/s");
  command.example("percuss model rigid --at 0:0.02:0.3 --cor 0.5 -o exit.csv",
                  "Choose the impact positions, and write a table");
  model::RigidCollision& c = flags->collision;
  command.value("--ball-mass", c.ball_mass_kg, "Set the mass of the ball").above_zero().type("KG").show_default();
  command.value("--bat-mass", c.bat_mass_kg, "Set the mass of the bat").above_zero().type("KG").show_default();
  command.value("--inertia", c.inertia_kgm2, "Set the moment of inertia of the bat about its centre of mass")
      .above_zero()
      .type("KG*M2")
      .show_default();
  command
      .value("--length", flags->length_m,
             "Set the length of the bat; without --at, positions reach from the centre of mass to half this length")
      .above_zero()
      .type("M")
      .show_default();
  command.value("--at", flags->at, "Set the impact positions in m from the centre of mass, positive towards the barrel")
      .type("LO:STEP:HI");
  command.value("--ball-speed", c.ball_speed_mps, "Set the speed of the ball towards the bat")
      .not_negative()
      .type("M/S")
      .show_default();
  command.value("--swing-rate", c.swing_rate_radps, "Set the rotation rate of the bat")
      .finite()
      .type("RAD/S")
      .show_default();
  command.value("--bat-speed", c.bat_speed_mps, "Set the speed of the bat's centre of mass towards the ball")
      .finite()
      .type("M/S")
      .show_default();
  command
      .value("--pivot", flags->pivot_m,
             "Set the distance of the pivot from the centre of mass, towards the knob; adds rate times distance to the "
             "speed of the centre of mass")
      .finite()
      .type("M");
  command.value("--cor", c.restitution, "Set the coefficient of restitution").within(0, 1).show_default();
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
