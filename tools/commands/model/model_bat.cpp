#include <memory>

#include "cli/option_error.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/model/bat_profile_file.hpp"
#include "commands/model/model_budget.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "report/bat_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kBatSteps = 60;
constexpr std::size_t kMaxBatModes = 200;
constexpr double kMaxWave_s = 0.1;

struct BatFlags {
  std::string profile, unit = "m:m", at, wave_times = "0:0.0002:0.002";
  model::BatMaterial material;
  model::BatCollision collision;
  std::size_t modes = model::BatModesOptions{}.modes;
  std::optional<double> wave_m;
  std::vector<double> budget;
  OutputFlags output;
};

std::vector<double> impact_positions_m(const BatFlags& flags, double length_m) {
  if (flags.at.empty())
    return Range{.low = 0, .step = length_m / static_cast<double>(kBatSteps), .count = kBatSteps + 1}.values();
  const Range range = parse_range("at", flags.at);
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

int model_bat(const BatFlags& flags) {
  check_report_outputs(flags.output);
  const ModelBudget budget(flags.budget, "model bat");
  const model::BatProfile profile = read_bat_profile(flags.profile, flags.unit);
  const std::vector<double> z_m = impact_positions_m(flags, profile.length_m());
  const auto wave = wave_of(flags, profile.length_m());
  const model::BatModes bat = model::bat_modes(profile, flags.material, {.modes = flags.modes});
  return show_report(report::bat_report(bat, profile, flags.collision, z_m, wave), flags.output, {flags.profile});
}

void add_ball(Command& command, model::BatCollision& c) {
  command.value("--ball-mass", c.ball.mass_kg, "Set the mass of the ball").above_zero().type("KG").show_default();
  command.value("--ball-speed", c.ball_speed_mps, "Set the speed of the ball towards the bat")
      .not_negative()
      .type("M/S")
      .show_default();
  command.value("--bat-speed", c.bat_speed_mps, "Set the speed of the bat's centre of mass towards the ball")
      .finite()
      .type("M/S")
      .show_default();
  command.value("--swing-rate", c.swing_rate_radps, "Set the rotation rate of the bat about its centre of mass")
      .finite()
      .type("RAD/S")
      .show_default();
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
      "Models a bat as a free beam of slices with bending and shear. Reports modes, mass, balance point and moment of "
      "inertia, and the exit speed of a ball at each impact position, beside the exit speed for a rigid bat. The "
      "profile is a file of two columns: the position of each slice's far end, from the knob, and the diameter.");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm",
                  "Read ends in cm and diameters in mm");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm --wave 0.7 -o bat.svg",
                  "Add the wave along the bat after an impact 0.7 m from the knob");
  command
      .value("--profile", flags->profile,
             "Read the profile from this file: the position of each slice's far end, from the knob, and the diameter")
      .required()
      .type("FILE");
  command.value("--profile-unit", flags->unit, "Set the units of the profile's two columns")
      .type("END:DIAMETER")
      .show_default();
  command.value("--density", flags->material.density_kgpm3, "Set the density of the bat")
      .above_zero()
      .type("KG/M3")
      .show_default();
  command.value("--young", flags->material.young_Pa, "Set Young's modulus along the bat")
      .above_zero()
      .type("PA")
      .show_default();
  command.value("--shear", flags->material.shear_Pa, "Set the shear modulus times the shape factor")
      .above_zero()
      .type("PA")
      .show_default();
  add_ball(command, flags->collision);
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
  add_model_budget(command, flags->budget);
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
