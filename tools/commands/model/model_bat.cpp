#include <memory>

#include "cli/option_error.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/model/frequency_fit_flags.hpp"
#include "commands/model/model_budget.hpp"
#include "commands/model/model_commands.hpp"
#include "commands/model/structure_flags.hpp"
#include "core/error.hpp"
#include "report/bat_report.hpp"
#include "report/beam_report.hpp"

namespace percuss::tools {
namespace {

constexpr double kHeldAt_m = 0.1524;  // 6 in: the pivot of bat tests, and the default of percuss::BatProfile

constexpr std::size_t kBatSteps = 60;
constexpr std::size_t kMaxBatModes = 200;
constexpr double kMaxWave_s = 0.1;

struct BatFlags {
  StructureFlags structure;
  FrequencyFitFlags fit;
  std::string at, wave_times = "0:0.0002:0.002";
  std::string support = "free";
  std::optional<double> support_m, torsion_Nmprad, bat_speed_mps, swing_rate_radps;
  model::BatCollision collision;
  std::size_t modes = model::BatModesOptions{}.modes;
  std::optional<double> wave_m;
  std::vector<double> budget;
  OutputFlags output;
};

std::vector<double> impact_positions_m(const BatFlags& flags, double length_m) {
  if (flags.at.empty())
    return Range{.low = 0, .step = length_m / static_cast<double>(kBatSteps), .count = kBatSteps + 1}.values();
  const Range range = parse_range("at", flags.at, RangeForm::several_values, "M");
  const double rounding_m = 1e-9 * length_m;  // tolerance for rounding
  if (range.low < 0 || range.high() > length_m + rounding_m)
    throw OptionError::wrong_value("at", flags.at, "give positions from the knob in m", "a position is off the bat");
  return range.values();
}

std::optional<report::BatWaveRequest> wave_of(const BatFlags& flags, double length_m) {
  if (!flags.wave_m) return {};
  if (!(*flags.wave_m <= length_m)) throw OptionError({"wave"}, "is off the bat", "give a position from the knob in m");
  const Range times = parse_range("wave_times", flags.wave_times);
  if (times.low < 0 || times.high() > kMaxWave_s) {
    throw OptionError({"wave_times"}, "leaves the range from 0 to 0.1 s",
                      "give LO:STEP:HI in s, such as 0:0.0002:0.002");
  }
  return report::BatWaveRequest{.z_m = *flags.wave_m, .time_s = times.values()};
}

model::StructureSupport support_of_bat(const BatFlags& flags, double length_m) {
  model::StructureSupport support{.kind = report::support_named(flags.support).value()};
  if (support.kind == model::BeamSupport::free) {
    if (flags.support_m)
      throw OptionError({"support_at"}, "needs a support, and the bat is free", "choose one", {"support"});
  } else {
    support.at_m = flags.support_m.value_or(kHeldAt_m);
    if (!(support.at_m <= length_m))
      throw OptionError({"support_at"}, "is off the bat", "give a position from the knob in m");
  }
  if (support.kind != model::BeamSupport::torsion) {
    if (flags.torsion_Nmprad) {
      throw OptionError({"torsion"}, "needs a torsion spring, and the support is " + flags.support, "omit one",
                        {"support"});
    }
    return support;
  }
  support.torsion_Nmprad = flags.torsion_Nmprad.value_or(model::UniformBeam().torsion_Nmprad);
  if (support.torsion_Nmprad == 0) support.kind = model::BeamSupport::pinned;
  return support;
}

// A free bat swings, a bat on a pin turns about it, any other is at rest.
model::BatCollision collision_of(const BatFlags& flags, model::BeamSupport support) {
  model::BatCollision collision = flags.collision;
  const bool free = support == model::BeamSupport::free, turns = free || support == model::BeamSupport::pinned;
  const auto refuse = [&](const char* option) {
    return OptionError({option}, "needs a bat that can move so, and the support is " + flags.support, "omit one",
                       {"support"});
  };
  if (!free && flags.bat_speed_mps.value_or(0) != 0) throw refuse("bat_speed");
  if (!turns && flags.swing_rate_radps.value_or(0) != 0) throw refuse("swing_rate");
  collision.bat_speed_mps = flags.bat_speed_mps.value_or(0);
  collision.swing_rate_radps = flags.swing_rate_radps.value_or(turns ? collision.swing_rate_radps : 0);
  return collision;
}

int model_bat(const BatFlags& flags) {
  check_report_outputs(flags.output);
  const ModelBudget budget(flags.budget, "model bat");
  model::BeamStructure structure = read_structure(flags.structure, {"position", "diameter"});
  structure.support = support_of_bat(flags, structure.length_m());
  const model::BatCollision collision = collision_of(flags, structure.support.kind);
  const std::vector<double> z_m = impact_positions_m(flags, structure.length_m());
  const auto wave = wave_of(flags, structure.length_m());
  report::StructureOrigin origin{.total_mass_kg = flags.structure.total_mass_kg};
  if (flags.fit.any()) {
    origin.measured = measured_modes(flags.fit, origin.first_mode);
    const auto parameters = structure_parameters(flags.fit, structure, origin.total_mass_kg.has_value());
    origin.fit = model::fit_structure(structure, parameters, origin.measured, {.total_mass_kg = origin.total_mass_kg});
    structure = origin.fit->structure;
  }
  origin.other = other_profile_kind(structure, flags.modes, model::BatModesOptions{}.max_element_fraction);
  const model::BatModes bat = model::bat_modes(structure, {.modes = flags.modes});
  return show_report(report::bat_report(bat, structure, collision, z_m, origin, wave), flags.output,
                     {flags.structure.profile});
}

void add_support(Command& command, BatFlags& flags) {
  command
      .value("--support", flags.support,
             "Choose how the bat is held: free, or at one position by a pin with a torsion spring, a pin or a clamp")
      .one_of({"free", "torsion", "pinned", "clamped"})
      .show_default();
  command
      .value("--support-at", flags.support_m, "Set the position of the support from the knob (default: 0.1524, 6 in)")
      .not_negative()
      .type("M");
  command.value("--torsion", flags.torsion_Nmprad, "Set the stiffness of the torsion spring (default: 1200)")
      .not_negative()
      .type("N*M/RAD");
}

void add_ball(Command& command, BatFlags& flags) {
  model::BatCollision& c = flags.collision;
  command.value("--ball-mass", c.ball.mass_kg, "Set the mass of the ball").above_zero().type("KG").show_default();
  command.value("--ball-speed", c.ball_speed_mps, "Set the speed of the ball towards the bat")
      .not_negative()
      .type("M/S")
      .show_default();
  command
      .value("--bat-speed", flags.bat_speed_mps,
             "Set the speed of a free bat's centre of mass towards the ball (default: 0)")
      .finite()
      .type("M/S");
  command
      .value("--swing-rate", flags.swing_rate_radps,
             "Set the rotation rate of a free bat about its centre of mass, or of a pinned bat about its pin "
             "(default: 60; a clamped bat, or one on a torsion spring, is at rest)")
      .finite()
      .type("RAD/S");
  command.value("--cor", c.ball.restitution, "Set the coefficient of restitution of the ball itself")
      .within(0.01, 1)
      .show_default();
  command.value("--ball-stiffness", c.ball.stiffness, "Set k of the ball's spring F = k u^alpha, in N/m^alpha")
      .above_zero()
      .type("K")
      .show_default();
  command.value("--ball-exponent", c.ball.exponent, "Set alpha of the ball's spring F = k u^alpha")
      .within(1, 5)
      .show_default();
}

}  // namespace

void add_model_bat(CommandLine& line) {
  auto flags = line.values<BatFlags>();
  Command command = line.command("model bat", "Predict the modes of a bat from its profile, and exit speeds along it",
                                 [flags] { return model_bat(*flags); });
  command.about(
      "Models a bat as a beam of sections with bending, shear and rotary inertia: solid or hollow, of one or several "
      "materials, round or rectangular, free or held, with added masses. Reports modes, mass, balance point and moment "
      "of inertia. For each impact position, reports the exit speed of a ball beside the exit speed for a rigid bat, "
      "and how the energy divides among ball and modes. --fit finds a constant of the bat from measured frequencies.");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm",
                  "Read ends in cm and diameters in mm");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm --wave 0.7 -o bat.svg",
                  "Add the wave along the bat after an impact 0.7 m from the knob");
  command.example(
      "percuss model bat --profile profile.txt --profile-unit cm:mm --profile-kind points --total-mass 0.88 --fit "
      "young --measured 165,568,1177",
      "Take the density from the mass, and fit Young's modulus");
  add_structure_flags(command, flags->structure, "slices", true);
  add_support(command, *flags);
  add_ball(command, *flags);
  command.value("--modes", flags->modes, "Use this many bending modes")
      .within(1, kMaxBatModes)
      .type("N")
      .show_default();
  command
      .value("--at", flags->at, "Set the impact positions from the knob in m (default: 61 positions over the length)")
      .type("LO:STEP:HI");
  command.value("--wave", flags->wave_m, "Add the deflection along the bat after an impact this far from the knob")
      .not_negative()
      .type("M");
  command
      .value("--wave-times", flags->wave_times, "Show the deflection of --wave at these times in s, from first contact")
      .type("LO:STEP:HI")
      .show_default();
  add_frequency_fit_flags(command, flags->fit, {"young", "shear", "density", "torsion", "added-mass"},
                          "Set the numbers of the measured modes, 1 for the first bending mode (default: the lowest)");
  add_model_budget(command, flags->budget);
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
