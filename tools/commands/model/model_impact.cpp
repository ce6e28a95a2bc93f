#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "cli/option_error.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/model/beam_flags.hpp"
#include "commands/model/model_budget.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "model/bat/struck_modes.hpp"
#include "report/impact_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxImpactModes = 100;
constexpr std::size_t kMaxSwept = 10000, kMaxCurves = 200;
constexpr double kMinStep = 1e-6, kMaxStep = 0.1;  // relative to the contact time with a wall
constexpr const char* kSweepForm = "give NAME=LO:STEP:HI with one of ei, torsion, rho-a, at, speed";

struct ModelImpactFlags {
  BeamFlags beam;
  model::Impact impact;
  double contact_cor = 1;
  std::string method = "modal";
  std::optional<double> step_s;
  std::vector<std::string> sweeps;
  bool curves = false;
  std::size_t threads = 0;
  std::vector<double> budget;
  OutputFlags output;
};

// A beam with a table of sections, and its modes.
struct NonuniformBeam {
  model::BeamStructure structure;
  model::BatModes modes;
};

model::BatModes modes_of(const model::BeamStructure& structure, std::size_t modes) {
  return model::bat_modes(structure, {.modes = modes, .max_element_fraction = kBeamElementFraction});
}

std::optional<NonuniformBeam> solved_nonuniform_beam(const ModelImpactFlags& flags) {
  auto structure = nonuniform_beam_of(flags.beam);
  if (!structure) return {};
  return NonuniformBeam{.structure = *structure, .modes = modes_of(*structure, flags.impact.modes)};
}

// Sets the modes at the struck point. Computes them again if the sweep changes the torsion spring.
void strike_nonuniform(const NonuniformBeam& nonuniform, model::Impact& impact) {
  if (impact.beam.torsion_Nmprad == nonuniform.structure.support.torsion_Nmprad) {
    impact.struck = model::struck_modes(nonuniform.modes, impact.at_m, impact.modes);
    return;
  }
  model::BeamStructure varied = nonuniform.structure;
  varied.support.torsion_Nmprad = impact.beam.torsion_Nmprad;
  varied.support.kind = impact.beam.torsion_Nmprad > 0 ? model::BeamSupport::torsion : model::BeamSupport::pinned;
  impact.struck = model::struck_modes(modes_of(varied, impact.modes), impact.at_m, impact.modes);
}

void check_impact_position(const OptionId& option, double at_m, const model::UniformBeam& beam) {
  if (!(at_m >= 0 && at_m <= beam.length_m)) {
    throw OptionError::wrong_value(option, fmt::format("{:g}", at_m), "strike from 0 to the length of the beam",
                                   "the ball misses the beam", {"length"});
  }
}

report::ImpactSweep parse_sweep(const std::string& text, const model::Impact& impact, bool nonuniform) {
  const std::size_t equals = text.find('=');
  report::ImpactSweep sweep{.parameter = text.substr(0, equals)};
  std::replace(sweep.parameter.begin(), sweep.parameter.end(), '-', '_');
  model::Impact trial = impact;
  if (equals == std::string::npos || report::swept_value(trial, sweep.parameter) == nullptr)
    throw OptionError::wrong_value("sweep", text, kSweepForm, "it is not a known name and a range");
  if (nonuniform && (sweep.parameter == "ei" || sweep.parameter == "rho_a"))
    throw OptionError::wrong_value("sweep", text, "vary torsion, at or speed", "the profile gives it", {"profile"});
  if (sweep.parameter == "torsion" && impact.beam.support != model::BeamSupport::torsion) {
    throw OptionError::wrong_value("sweep", text, "choose the torsion support", "the beam has no torsion spring",
                                   {"support"});
  }
  const char* const unit = sweep.parameter == "at" ? "M" : sweep.parameter == "speed" ? "M/S" : "";
  const Range range = parse_range("sweep", text.substr(equals + 1), RangeForm::several_values, unit);
  const bool from_zero = sweep.parameter == "at" || sweep.parameter == "torsion";
  if (range.low < 0 || (range.low == 0 && !from_zero))
    throw OptionError::wrong_value("sweep", text, kSweepForm, "the values must be above zero");
  sweep.values = range.values();
  if (sweep.parameter == "at") {
    for (const double at_m : sweep.values) check_impact_position("sweep", at_m, impact.beam);
  }
  return sweep;
}

void run_sweep(const model::Impact& impact, const std::optional<NonuniformBeam>& nonuniform,
               const model::ImpactOptions& options, std::size_t threads, report::ImpactSweep& sweep) {
  sweep.results.resize(sweep.values.size());
  parallel_for(sweep.values.size(), threads, [&](std::size_t i) {
    model::Impact varied = impact;
    *report::swept_value(varied, sweep.parameter) = sweep.values[i];
    if (nonuniform) strike_nonuniform(*nonuniform, varied);
    sweep.results[i] = model::simulate_impact(varied, options);
  });
}

model::ImpactOptions impact_options(const ModelImpactFlags& flags, const model::Impact& impact) {
  model::ImpactOptions options;
  if (flags.method == "small-increment") options.method = model::ImpactMethod::small_increment;
  if (flags.step_s) {
    const double wall_s = model::hertz_contact_s(impact);
    if (!(*flags.step_s >= kMinStep * wall_s && *flags.step_s <= kMaxStep * wall_s)) {
      throw OptionError(
          {"step"}, "is not between a millionth and a tenth of the contact time",
          "give a step within these limits; this ball touches a wall for " + std::to_string(1e6 * wall_s) + " µs");
    }
    options.step_s = *flags.step_s;
  }
  options.series = flags.curves && flags.output.host != nullptr;  // the caller of a host may read the curves
  for (const std::string& path : flags.output.paths)
    options.series = options.series || ((flags.sweeps.empty() || flags.curves) && extension_of(path) != ".json");
  return options;
}

int model_impact(const ModelImpactFlags& flags) {
  check_report_outputs(flags.output);
  const ModelBudget budget(flags.budget, "model impact");
  model::Impact impact = flags.impact;
  const std::optional<NonuniformBeam> nonuniform = solved_nonuniform_beam(flags);
  impact.beam = beam_of(flags.beam);
  if (nonuniform) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    impact.beam.length_m = nonuniform->structure.length_m();
    impact.beam.stiffness_Nm2 = impact.beam.mass_per_length_kgpm = kNone;
  }
  check_impact_position("at", impact.at_m, impact.beam);
  if (nonuniform) strike_nonuniform(*nonuniform, impact);
  impact.hysteresis_spm = model::hysteresis_for_spm(flags.contact_cor, impact.speed_mps);
  std::vector<report::ImpactSweep> sweeps;
  sweeps.reserve(flags.sweeps.size());
  std::size_t swept = 0;
  for (const std::string& text : flags.sweeps) {
    sweeps.push_back(parse_sweep(text, impact, nonuniform.has_value()));
    swept += sweeps.back().values.size();
  }
  if (swept > kMaxSwept) throw OptionError({"sweep"}, "has more than 10000 values in all", "give fewer values");
  if (flags.curves && (swept == 0 || swept > kMaxCurves)) {
    throw OptionError({"curves"}, fmt::format("shows the impacts of a sweep, up to {}", kMaxCurves),
                      "sweep 1 to 200 values", {"sweep"});
  }
  const model::ImpactOptions options = impact_options(flags, impact);
  const model::ImpactResult result = model::simulate_impact(impact, options);
  for (report::ImpactSweep& sweep : sweeps) run_sweep(impact, nonuniform, options, flags.threads, sweep);
  std::optional<report::StructureOrigin> origin;
  if (nonuniform) {
    origin = report::StructureOrigin{.total_mass_kg = flags.beam.structure.total_mass_kg,
                                     .first_mode = model::rigid_body_modes(nonuniform->structure.support.kind)};
    origin->other = other_profile_kind(nonuniform->structure, flags.impact.modes, kBeamElementFraction);
  }
  return show_report(report::impact_report(impact, result, sweeps, nonuniform ? &nonuniform->structure : nullptr,
                                           origin.value_or(report::StructureOrigin{})),
                     flags.output,
                     nonuniform ? std::vector<std::string>{flags.beam.structure.profile} : std::vector<std::string>{});
}

}  // namespace

void add_model_impact(CommandLine& line) {
  auto flags = line.values<ModelImpactFlags>();
  Command command =
      line.command("model impact", "Predict the impact of a ball on a beam: restitution, force and deflection",
                   [flags] { return model_impact(*flags); });
  command.about(
      "Simulates the impact of a ball on the beam of percuss model beam: coefficient of restitution (COR) after the "
      "first contact and after the last, contact time, largest force, and deflection of the beam until 80 ms after the "
      "first contact. --sweep varies constants of the beam, the impact position or the speed.");
  command.example("percuss model impact --at 0.5 --speed 6", "Simulate one impact, 0.5 m from the spring at 6 m/s");
  command.example("percuss model impact --sweep ei=1000:1000:6000 --sweep rho-a=0.6:0.2:3 -o curves.svg",
                  "Draw the COR against stiffness and mass");
  command.example("percuss model impact --sweep at=0.025:0.065:0.545 --curves -o curves.svg -o curves.csv",
                  "Draw the deflection over time at nine struck points, and write it as a table");
  add_beam_flags(command, flags->beam);
  model::Impact& impact = flags->impact;
  command.value("--at", impact.at_m, "Set the impact position, from x = 0").not_negative().type("M").show_default();
  command.value("--ball-mass", impact.ball_mass_kg, "Set the mass of the ball").above_zero().type("KG").show_default();
  command.value("--speed", impact.speed_mps, "Set the speed of the ball").above_zero().type("M/S").show_default();
  command.value("--hertz", impact.hertz_Npm15, "Set the Hertz constant: force over approach^(3/2)")
      .above_zero()
      .type("N/M^1.5")
      .show_default();
  command
      .value("--contact-cor", flags->contact_cor,
             "Set the COR of the ball on a rigid wall at --speed; below 1 the contact loses energy (hysteresis)")
      .within(0.01, 1)
      .show_default();
  command.value("--modes", impact.modes, "Use this many modes of the beam, including rigid-body modes")
      .within(1, kMaxImpactModes)
      .type("N")
      .show_default();
  command
      .value("--method", flags->method,
             "Choose the integration. modal: exact between force steps; small-increment: first order, constant force "
             "in each step")
      .one_of({"modal", "small-increment"})
      .show_default();
  command
      .value("--step", flags->step_s,
             "Set the time step (default: for modal, adaptive steps with restitution and energy accurate to 1e-9; for "
             "small-increment, 1e-5)")
      .above_zero()
      .type("S");
  command
      .repeatable(
          "--sweep", flags->sweeps,
          "Vary ei, torsion, rho-a, at or speed, in the unit of the option, with the others constant (repeatable)")
      .type("NAME=LO:STEP:HI");
  command.flag("--curves", flags->curves,
               "Write and draw the motion over time of each impact of the sweep, in place of one row each");
  command.value("--threads", flags->threads, "Use this many threads (default: all; the result is the same)")
      .within(0, 1024)
      .type("N");
  add_model_budget(command, flags->budget);
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
