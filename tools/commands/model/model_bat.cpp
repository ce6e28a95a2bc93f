#include <memory>

#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "commands/model/bat_profile_file.hpp"
#include "core/error.hpp"
#include "report/bat_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kBatSteps = 60;
constexpr std::size_t kMaxBatModes = 200;
constexpr double kLongestWave_s = 0.1;

struct BatFlags {
  std::string profile, unit = "m:m", at, wave_times = "0:0.0002:0.002";
  model::BatMaterial material;
  model::BatCollision collision;
  std::size_t modes = model::BatModesOptions{}.modes;
  std::optional<double> wave_m;
  OutputFlags output;
};

std::vector<double> places(const BatFlags& flags, double length_m) {
  if (flags.at.empty())
    return Range{.low = 0, .step = length_m / static_cast<double>(kBatSteps), .count = kBatSteps + 1}.values();
  const Range range = parse_range("--at", flags.at);
  const double beyond = 1e-9 * length_m;  // what rounding may add
  if (range.low < 0 || range.high() > length_m + beyond)
    throw UsageError("--at " + one_line(flags.at, 40) + " is not on the bat", "give positions from the knob in m");
  return range.values();
}

std::optional<report::BatWaveRequest> wave_of(const BatFlags& flags, double length_m) {
  if (!flags.wave_m) return {};
  if (!(*flags.wave_m <= length_m)) throw UsageError("--wave is not on the bat", "give a position from the knob in m");
  const Range times = parse_range("--wave-times", flags.wave_times);
  if (times.low < 0 || times.high() > kLongestWave_s)
    throw UsageError("--wave-times go beyond 0 to 0.1 s", "give LO:STEP:HI in s, as 0:0.0002:0.002");
  return report::BatWaveRequest{.z_m = *flags.wave_m, .time_s = times.values()};
}

int model_bat(const BatFlags& flags) {
  check_report_outputs(flags.output);
  const model::BatProfile profile = read_bat_profile(flags.profile, flags.unit);
  const std::vector<double> z_m = places(flags, profile.length_m());
  const auto wave = wave_of(flags, profile.length_m());
  const model::BatModes bat = model::bat_modes(profile, flags.material, {.modes = flags.modes});
  return show_report(report::bat_report(bat, profile, flags.collision, z_m, wave), flags.output, {flags.profile});
}

void add_ball(Command& command, model::BatCollision& c) {
  command.value("--ball-mass", c.ball.mass_kg, "Mass of the ball").above_zero().type("KG").show_default();
  command.value("--ball-speed", c.ball_speed_mps, "Speed of the ball towards the bat")
      .not_negative()
      .type("M/S")
      .show_default();
  command.value("--bat-speed", c.bat_speed_mps, "Speed of the bat's centre of mass towards the ball")
      .finite()
      .type("M/S")
      .show_default();
  command.value("--swing-rate", c.swing_rate_radps, "Rate of the bat's rotation about its centre of mass")
      .finite()
      .type("RAD/S")
      .show_default();
  command.value("--cor", c.ball.restitution, "Coefficient of restitution of the ball itself")
      .within(0.01, 1)
      .show_default();
  command.value("--ball-stiffness", c.ball.stiffness, "The ball is a spring: k of F = k u^alpha, in N/m^alpha")
      .above_zero()
      .type("K")
      .show_default();
  command.value("--ball-exponent", c.ball.exponent, "alpha of F = k u^alpha").within(1, 5).show_default();
}

}  // namespace

void add_model_bat(CommandLine& line) {
  auto flags = line.values<BatFlags>();
  Command command =
      line.command("model bat", "Modes of a bat from its profile, and exit speed of a ball over the impact's position",
                   [flags] { return model_bat(*flags); });
  command.about(
      "A bat as a beam of slices, each with bending and shear, free at both ends: its modes, mass, balance and "
      "inertia, and the exit speed of a ball over the place of the impact, beside that of a rigid bat. The profile is "
      "a file of two columns: where each slice ends, from the knob, and its diameter.");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm", "Ends in cm, diameters in mm");
  command.example("percuss model bat --profile profile.txt --profile-unit cm:mm --wave 0.7 -o bat.svg",
                  "Also how the wave runs along the bat after an impact 0.7 m from the knob");
  command.value("--profile", flags->profile, "File of two columns: far end of a slice from the knob, and its diameter")
      .required()
      .type("FILE");
  command.value("--profile-unit", flags->unit, "Units of its two columns").type("END:DIAMETER").show_default();
  command.value("--density", flags->material.density_kgpm3, "Density of the bat")
      .above_zero()
      .type("KG/M3")
      .show_default();
  command.value("--young", flags->material.young_Pa, "Young's modulus along the bat")
      .above_zero()
      .type("PA")
      .show_default();
  command.value("--shear", flags->material.shear_Pa, "Shear modulus times shape factor")
      .above_zero()
      .type("PA")
      .show_default();
  add_ball(command, flags->collision);
  command.value("--modes", flags->modes, "Bending modes that take part")
      .within(1, kMaxBatModes)
      .type("N")
      .show_default();
  command.value("--at", flags->at, "Positions of the impact from the knob, in m (default: 61 over the length)")
      .type("LO:STEP:HI");
  command.value("--wave", flags->wave_m, "Show the deflection along the bat after an impact this far from the knob")
      .not_negative()
      .type("M");
  command.value("--wave-times", flags->wave_times, "With --wave: at these times in s, from the touch on")
      .type("LO:STEP:HI")
      .show_default();
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
