#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/report_output.hpp"
#include "commands/commands.hpp"
#include "commands/model/beam_flags.hpp"
#include "core/error.hpp"
#include "report/beam_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxBeamModes = 200;
constexpr const char* kStaticForm = "give LOAD:LEVER:DEFLECTION, in N, m from the spring and m";

struct ModelBeamFlags {
  BeamFlags beam;
  std::optional<double> gyration_m, shear_stiffness_N;
  std::size_t modes = 10;
  std::vector<std::string> fit, readings;
  std::vector<double> measured_Hz, measured_std_Hz;
  std::vector<std::size_t> measured_modes;
  OutputFlags output;
};

struct FitName {
  const char* name;
  model::BeamParameter which;
  bool given;  // its own option as well
};

std::vector<model::BeamParameter> asked_parameters(const ModelBeamFlags& flags) {
  const BeamFlags& b = flags.beam;
  const std::vector<FitName> names{
      {"ei", model::BeamParameter::stiffness, b.stiffness_Nm2.has_value() || !b.layers.empty()},
      {"torsion", model::BeamParameter::torsion, b.torsion_Nmprad.has_value() || !flags.readings.empty()},
      {"rho-a", model::BeamParameter::mass_per_length, b.mass_per_length_kgpm.has_value()}};
  std::vector<model::BeamParameter> asked;
  for (const std::string& word : flags.fit) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const FitName& one) { return word == one.name; });
    if (found->given) throw UsageError("--fit " + word + ": its value is given as well", "leave one out");
    if (std::find(asked.begin(), asked.end(), found->which) != asked.end())
      throw UsageError("--fit " + word + ": named twice", "name each once");
    asked.push_back(found->which);
  }
  return asked;
}

// What frequencies cannot tell is not fitted.
void check_fit(const ModelBeamFlags& flags, model::BeamSupport support,
               const std::vector<model::BeamParameter>& asked) {
  if (asked.empty()) throw UsageError("--measured: nothing is to be fitted to it", "say what, as --fit ei,torsion");
  const bool spring = support == model::BeamSupport::torsion;
  if (!spring && std::find(asked.begin(), asked.end(), model::BeamParameter::torsion) != asked.end()) {
    throw UsageError("--fit torsion: a beam with --support " + flags.beam.support + " has no spring",
                     "fit ei or rho-a");
  }
  if (asked.size() > model::max_beam_parameters(support)) {
    throw UsageError(spring ? "--fit: frequencies tell EI/ρA and T·L/EI only, not all three"
                            : "--fit: without a spring frequencies tell EI/ρA only, not both",
                     "leave one out and give its value (--ei, --rho-a or --torsion)");
  }
  if (flags.measured_Hz.size() < asked.size())
    throw UsageError("--fit: more unknowns than frequencies", "give as many in --measured, or more");
}

std::vector<model::MeasuredFrequency> measured_frequencies(const ModelBeamFlags& flags, model::BeamSupport support) {
  const std::size_t rigid = model::rigid_body_modes(support);
  const std::size_t count = flags.measured_Hz.size();
  const auto& std_Hz = flags.measured_std_Hz;
  if (!flags.measured_modes.empty() && flags.measured_modes.size() != count)
    throw UsageError("--measured-modes: not as many as frequencies in --measured", "give one each");
  if (std_Hz.size() > 1 && std_Hz.size() != count)
    throw UsageError("--measured-std: not as many as frequencies in --measured", "give one each, or one for all");
  std::vector<model::MeasuredFrequency> measured;
  measured.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t mode = flags.measured_modes.empty() ? rigid + i : flags.measured_modes[i];
    if (mode < rigid || mode >= kMaxBeamModes)
      throw UsageError("--measured-modes: a rigid-body mode, or not below 200", "use the numbers of the table");
    if (i > 0 && !(flags.measured_Hz[i] > flags.measured_Hz[i - 1] && mode > measured.back().mode))
      throw UsageError("--measured: frequencies and their modes must rise", "sort them");
    measured.push_back({.mode = mode,
                        .freq_Hz = flags.measured_Hz[i],
                        .std_Hz = std_Hz.empty() ? 0 : std_Hz[std::min(i, std_Hz.size() - 1)]});
  }
  return measured;
}

model::TorsionFit static_torsion(const ModelBeamFlags& flags, const model::UniformBeam& beam) {
  if (beam.support != model::BeamSupport::torsion)
    throw UsageError("--static: a beam with --support " + flags.beam.support + " has no spring", "leave one out");
  if (flags.beam.torsion_Nmprad) throw UsageError("--static and --torsion both say the same", "leave one out");
  std::vector<model::StaticReading> readings;
  readings.reserve(flags.readings.size());
  for (const std::string& text : flags.readings) {
    const std::vector<double> number = parse_colon_list("--static", text, 3, 3, kStaticForm);
    if (number[1] > beam.length_m)
      throw UsageError("--static " + one_line(text, 80) + ": the lever is longer than the beam", kStaticForm);
    readings.push_back({.load_N = number[0], .lever_m = number[1], .deflection_m = number[2]});
  }
  return model::fit_torsion(readings, beam.stiffness_Nm2);
}

int model_beam(const ModelBeamFlags& flags) {
  check_report_outputs(flags.output);
  model::UniformBeam beam = beam_of(flags.beam);
  beam.gyration_m = flags.gyration_m.value_or(0);
  beam.shear_stiffness_N = flags.shear_stiffness_N.value_or(0);
  report::BeamOrigin origin;
  const std::vector<model::BeamParameter> asked = asked_parameters(flags);
  if (!flags.readings.empty()) {
    if (std::find(asked.begin(), asked.end(), model::BeamParameter::stiffness) != asked.end())
      throw UsageError("--static needs the EI that --fit ei is to find", "fit rho-a, or give --ei");
    origin.torsion = static_torsion(flags, beam);
    beam.torsion_Nmprad = origin.torsion->torsion_Nmprad;
  }
  if (!asked.empty() || !flags.measured_Hz.empty() || !flags.measured_std_Hz.empty() || !flags.measured_modes.empty()) {
    check_fit(flags, beam.support, asked);
    origin.measured = measured_frequencies(flags, beam.support);
    origin.fit = model::fit_beam(beam, asked, origin.measured);
    beam = origin.fit->beam;
  }
  return show_report(report::beam_report(beam, model::beam_modes(beam, flags.modes), origin), flags.output);
}

}  // namespace

void add_model_beam(CommandLine& line) {
  auto flags = line.values<ModelBeamFlags>();
  Command command = line.command("model beam", "Natural frequencies, nodes and shapes of a uniform beam",
                                 [flags] { return model_beam(*flags); });
  command.about(
      "A uniform beam held at one end, at first by a torsion spring as a bat in its clamp: frequencies in Hz, nodes in "
      "m from the held end, shapes. With --fit the stiffness, the spring or the mass follow from measured frequencies, "
      "with standard deviations.");
  command.example("percuss model beam --support free --length 0.84 --modes 6", "A free beam of 0.84 m");
  command.example("percuss model beam --fit ei,torsion --measured 14.5,322,1038 --measured-std 0.1,1,4",
                  "Stiffness and spring from three measured frequencies");
  command.example("percuss model beam --layer 70e9:0.03:0.002:2700 --layer 10e9:0.03:0.02:700 -o beam.html",
                  "A section of two layers, drawn on a page");
  add_beam_flags(command, flags->beam);
  command.value("--modes", flags->modes, "Modes to list, rigid-body modes (0 Hz) included")
      .within(1, kMaxBeamModes)
      .type("N")
      .show_default();
  command.value("--gyration", flags->gyration_m, "Radius of gyration √(I/A): with rotary inertia (Timoshenko)")
      .above_zero()
      .type("M");
  command.value("--shear-stiffness", flags->shear_stiffness_N, "Shear stiffness κGA: with shear (Timoshenko)")
      .above_zero()
      .type("NEWTON");
  const std::string before = command.heading("The beam from measurements");
  command.list("--fit", flags->fit, "Find these from --measured").type("NAME,...").one_of({"ei", "torsion", "rho-a"});
  command.list("--measured", flags->measured_Hz, "Measured frequencies, lowest first").above_zero().type("HZ,...");
  command.list("--measured-std", flags->measured_std_Hz, "Their standard deviations, or one for all")
      .above_zero()
      .type("HZ,...");
  command
      .list("--measured-modes", flags->measured_modes,
            "Which modes they are, by the table's numbers (default: the lowest elastic ones)")
      .type("N,...");
  command
      .repeatable("--static", flags->readings,
                  "The spring's stiffness from a load across the beam in N, its distance from the spring in m, and the "
                  "deflection there in m (repeatable)")
      .type("LOAD:LEVER:DEFLECTION");
  command.heading(before);
  add_output_flags(command, flags->output, kReportKinds);
}

}  // namespace percuss::tools
