#include <algorithm>
#include <memory>
#include <utility>

#include "cli/option_error.hpp"
#include "cli/report_output.hpp"
#include "commands/model/beam_flags.hpp"
#include "commands/model/frequency_fit_flags.hpp"
#include "commands/model/model_budget.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "report/beam_report.hpp"
#include "report/nonuniform_beam_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxBeamModes = 200;
constexpr const char* kStaticForm = "give LOAD:LEVER:DEFLECTION, in N, m from the spring and m";

struct ModelBeamFlags {
  BeamFlags beam;
  std::optional<double> gyration_m, shear_stiffness_N;
  std::size_t modes = 10;
  FrequencyFitFlags fit;
  std::vector<std::string> readings;
  std::vector<double> budget;
  OutputFlags output;
};

struct FitName {
  const char* name;
  model::BeamParameter which;
};

std::vector<model::BeamParameter> fitted_parameters(const ModelBeamFlags& flags) {
  const std::vector<FitName> names{{"ei", model::BeamParameter::stiffness},
                                   {"torsion", model::BeamParameter::torsion},
                                   {"rho-a", model::BeamParameter::mass_per_length}};
  std::vector<model::BeamParameter> fitted;
  for (const std::string& name : flags.fit.names) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const FitName& one) { return name == one.name; });
    if (found == names.end())
      throw OptionError::wrong_value("fit", name, "fit ei, torsion or rho-a", "it needs a profile", {"profile"});
    if (found->which == model::BeamParameter::torsion && !flags.readings.empty()) {
      throw OptionError::wrong_value("fit", name, "omit one", "the static readings determine the spring as well",
                                     {"static"});
    }
    if (std::find(fitted.begin(), fitted.end(), found->which) != fitted.end())
      throw OptionError::wrong_value("fit", name, "name each parameter once", "it is named twice");
    fitted.push_back(found->which);
  }
  return fitted;
}

bool fits_torsion(const std::vector<model::BeamParameter>& fitted) {
  return std::find(fitted.begin(), fitted.end(), model::BeamParameter::torsion) != fitted.end();
}

// Rejects parameters that frequencies do not determine. measured_modes() rejects a fit without parameters, and one with
// more parameters than frequencies.
void check_fit(const ModelBeamFlags& flags, model::BeamSupport support,
               const std::vector<model::BeamParameter>& fitted) {
  const bool spring = support == model::BeamSupport::torsion;
  if (!spring && fits_torsion(fitted)) {
    throw OptionError::wrong_value("fit", "torsion", "fit ei or rho-a",
                                   "the support is " + flags.beam.support + ", without a spring", {"support"});
  }
  if (fitted.size() > model::max_beam_parameters(support)) {
    throw OptionError({"fit"},
                      spring ? "has three parameters, but frequencies determine EI/ρA and T·L/EI only"
                             : "has two parameters, but without a spring frequencies determine EI/ρA only",
                      "omit one and give its value", {"ei", "rho_a", "torsion"});
  }
}

std::vector<model::MeasuredFrequency> measured_frequencies(const ModelBeamFlags& flags, model::BeamSupport support) {
  const std::size_t rigid = model::rigid_body_modes(support);
  std::vector<model::MeasuredFrequency> measured;
  for (const model::MeasuredMode& one : measured_modes(flags.fit, rigid))
    measured.push_back({.mode = rigid + one.elastic, .freq_Hz = one.freq_Hz, .std_Hz = one.std_Hz});
  return measured;
}

model::TorsionFit static_torsion(const ModelBeamFlags& flags, const model::UniformBeam& beam) {
  if (beam.support != model::BeamSupport::torsion) {
    throw OptionError({"static"}, "needs a torsion spring, and the support is " + flags.beam.support, "omit one",
                      {"support"});
  }
  if (flags.beam.torsion_Nmprad)
    throw OptionError({"static", "torsion"}, "both give the stiffness of the spring", "omit one");
  std::vector<model::StaticReading> readings;
  readings.reserve(flags.readings.size());
  for (const std::string& text : flags.readings) {
    const std::vector<double> number = parse_colon_list("static", text, 3, 3, kStaticForm);
    if (number[1] > beam.length_m)
      throw OptionError::wrong_value("static", text, kStaticForm, "the lever is longer than the beam");
    readings.push_back({.load_N = number[0], .lever_m = number[1], .deflection_m = number[2]});
  }
  return model::fit_torsion(readings, beam.stiffness_Nm2);
}

int model_nonuniform_beam(const ModelBeamFlags& flags, model::BeamStructure beam) {
  for (const auto& [given, option] : {std::pair{flags.gyration_m.has_value(), "gyration"},
                                      std::pair{flags.shear_stiffness_N.has_value(), "shear_stiffness"},
                                      std::pair{!flags.readings.empty(), "static"}}) {
    if (given) throw OptionError({option}, "belongs to a uniform beam", "omit one", {"profile"});
  }
  const std::size_t rigid = model::rigid_body_modes(beam.support.kind);
  report::StructureOrigin origin{.total_mass_kg = flags.beam.structure.total_mass_kg, .first_mode = rigid};
  if (flags.fit.any()) {
    origin.measured = measured_modes(flags.fit, rigid);
    const auto parameters = structure_parameters(flags.fit, beam, origin.total_mass_kg.has_value());
    origin.fit =
        model::fit_structure(beam, parameters, origin.measured,
                             {.total_mass_kg = origin.total_mass_kg, .max_element_fraction = kBeamElementFraction});
    beam = origin.fit->structure;
  }
  const std::size_t elastic = flags.modes > rigid ? flags.modes - rigid : 1;
  origin.other = other_profile_kind(beam, elastic, kBeamElementFraction);
  const model::BatModes modes =
      model::bat_modes(beam, {.modes = elastic, .max_element_fraction = kBeamElementFraction});
  return show_report(report::nonuniform_beam_report(beam, modes, flags.modes, origin), flags.output,
                     {flags.beam.structure.profile});
}

int model_beam(const ModelBeamFlags& flags) {
  check_report_outputs(flags.output);
  const ModelBudget budget(flags.budget, "model beam");
  if (auto nonuniform = nonuniform_beam_of(flags.beam)) return model_nonuniform_beam(flags, std::move(*nonuniform));
  model::UniformBeam beam = beam_of(flags.beam);
  beam.gyration_m = flags.gyration_m.value_or(0);
  beam.shear_stiffness_N = flags.shear_stiffness_N.value_or(0);
  report::BeamOrigin origin;
  const std::vector<model::BeamParameter> fitted = fitted_parameters(flags);
  if (!flags.readings.empty()) {
    if (std::find(fitted.begin(), fitted.end(), model::BeamParameter::stiffness) != fitted.end())
      throw OptionError({"static"}, "needs EI, which is to be fitted", "fit rho-a, with EI given", {"ei"});
    origin.torsion = static_torsion(flags, beam);
    beam.torsion_Nmprad = origin.torsion->torsion_Nmprad;
  }
  if (flags.fit.any()) {
    // Without a stiffness the spring is a pin, whose first mode is a rigid-body mode.
    if (beam.support == model::BeamSupport::torsion && beam.torsion_Nmprad == 0 && !fits_torsion(fitted))
      beam.support = model::BeamSupport::pinned;
    check_fit(flags, beam.support, fitted);
    origin.measured = measured_frequencies(flags, beam.support);
    origin.fit = model::fit_beam(beam, fitted, origin.measured);
    beam = origin.fit->beam;
  }
  return show_report(report::beam_report(beam, model::beam_modes(beam, flags.modes), origin), flags.output);
}

}  // namespace

void add_model_beam(CommandLine& line) {
  auto flags = line.values<ModelBeamFlags>();
  Command command = line.command("model beam", "Predict natural frequencies, nodes and shapes of a beam",
                                 [flags] { return model_beam(*flags); });
  command.about(
      "Models a beam that is free, or held at x = 0; the default support is a torsion spring, as for a clamped bat. "
      "The beam is uniform, or has the sections of a table (--profile). Reports frequencies in Hz, the places x of "
      "the nodes, and shapes. --fit finds the stiffness, the spring or the mass from measured frequencies, with "
      "standard deviations.");
  command.example("percuss model beam --support free --length 0.84 --modes 6", "Model a free beam of 0.84 m");
  command.example("percuss model beam --fit ei,torsion --measured 14.5,322,1038 --measured-std 0.1,1,4",
                  "Fit stiffness and spring to three measured frequencies");
  command.example("percuss model beam --layer 70e9:0.03:0.002:2700 --layer 10e9:0.03:0.02:700 -o beam.html",
                  "Model a section of two layers, and write a page");
  command.example("percuss model beam --profile blade.csv --profile-unit mm:mm --young 1.1e10 --density 450",
                  "Model a blade from its widths and thicknesses");
  add_beam_flags(command, flags->beam);
  command.value("--modes", flags->modes, "List this many modes, including rigid-body modes (0 Hz)")
      .within(1, kMaxBeamModes)
      .type("N")
      .show_default();
  command.value("--gyration", flags->gyration_m, "Add rotary inertia (Timoshenko) with this radius of gyration √(I/A)")
      .above_zero()
      .type("M");
  command.value("--shear-stiffness", flags->shear_stiffness_N, "Add shear (Timoshenko) with this shear stiffness κGA")
      .above_zero()
      .type("NEWTON");
  add_frequency_fit_flags(
      command, flags->fit, {"ei", "torsion", "rho-a", "young", "shear", "density", "added-mass"},
      "Set the mode numbers of the measured frequencies, as in the table (default: the lowest elastic modes)");
  const std::string previous = command.heading("Fit to measurements");
  command
      .repeatable("--static", flags->readings,
                  "Compute the spring's stiffness from a transverse load in N, its distance from the spring in m, and "
                  "the deflection there in m (repeatable)")
      .type("LOAD:LEVER:DEFLECTION");
  command.heading(previous);
  add_model_budget(command, flags->budget);
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
