#include <cmath>
#include <memory>

#include "cli/option_error.hpp"
#include "cli/report_output.hpp"
#include "commands/model/colon_numbers.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "report/shell_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxPattern = 100;  // waves around, half-waves along
constexpr const char* kHoopForm = "give N:M:HZ:STD, such as 2:1:1756:2,2:2:2624:3 (n waves around, m half-waves along)";

struct ShellFlags {
  model::TubeShell shell;
  std::size_t n = 2, modes = 3;
  std::vector<std::string> measured;
  std::string unknowns = "young";
  OutputFlags output;
};

model::MeasuredHoop measured_hoop(const std::string& text) {
  const auto refuse = [&] { return OptionError::wrong_value("measured", text, kHoopForm); };
  const std::vector<double> values = numbers_between_colons(text).value_or(std::vector<double>());
  const auto is_count = [](double x, double least) { return x >= least && x <= kMaxPattern && x == std::floor(x); };
  if (values.size() != 4 || !is_count(values[0], 2) || !is_count(values[1], 1)) throw refuse();
  if (!(values[2] > 0 && values[3] > 0)) throw refuse();
  return {.n = static_cast<std::size_t>(values[0]),
          .m = static_cast<std::size_t>(values[1]),
          .freq_Hz = values[2],
          .freq_std_Hz = values[3]};
}

int model_shell(const ShellFlags& flags) {
  check_report_outputs(flags.output);
  if (!(flags.shell.wall_m < flags.shell.outer_diameter_m / 2)) {
    throw OptionError({"wall"}, "is half of the outer diameter or more", "give the thickness of the wall in m",
                      {"outer_diameter"});
  }
  model::TubeShell shell = flags.shell;
  std::optional<report::FittedShell> fitted;
  if (!flags.measured.empty()) {
    fitted.emplace();
    fitted->measured.reserve(flags.measured.size());
    for (const std::string& text : flags.measured) fitted->measured.push_back(measured_hoop(text));
    fitted->fit = model::fit_shell(shell, fitted->measured,
                                   flags.unknowns == "both"   ? model::ShellUnknowns::both
                                   : flags.unknowns == "wall" ? model::ShellUnknowns::wall
                                                              : model::ShellUnknowns::young);
    shell = fitted->fit.shell;
  }
  return show_report(report::shell_report(shell, flags.n, flags.modes, fitted), flags.output);
}

}  // namespace

void add_model_shell(CommandLine& line) {
  auto flags = line.values<ShellFlags>();
  Command command =
      line.command("model shell", "Predict hoop frequencies of a barrel as a tube: ring, Rayleigh, Love, Flügge",
                   [flags] { return model_shell(*flags); });
  command.about(
      "Models the barrel as a tube. Reports hoop frequencies in Hz for n waves around the tube by four theories: "
      "the shapes of ring and Rayleigh are constant along the tube, the shape of Love grows linearly from its middle, "
      "and the shape of Flügge has m half-waves along it. --measured fits Young's modulus, the wall or both to "
      "measured frequencies.");
  command.example("percuss model shell --outer-diameter 0.0667 --wall 0.0025", "Model a barrel of aluminium");
  command.example("percuss model shell --wall 0.0025 --measured 2:1:1700:5 --fit young",
                  "Fit Young's modulus to 1700 ± 5 Hz");
  model::TubeShell& s = flags->shell;
  command.value("--outer-diameter", s.outer_diameter_m, "Set the outer diameter of the tube")
      .above_zero()
      .type("M")
      .show_default();
  command.value("--wall", s.wall_m, "Set the thickness of the wall").above_zero().type("M").show_default();
  command.value("--length", s.length_m, "Set the length of the tube").above_zero().type("M").show_default();
  command.value("--young", s.young_Pa, "Set Young's modulus of the wall").above_zero().type("PA").show_default();
  command.value("--density", s.density_kgpm3, "Set the density of the wall").above_zero().type("KG/M3").show_default();
  command.value("--poisson", s.poisson, "Set Poisson's ratio").within(0, 0.499).show_default();
  command.value("--n", flags->n, "Set the number n of waves around the tube")
      .within(2, kMaxPattern)
      .type("N")
      .show_default();
  command.value("--modes", flags->modes, "List modes with m from 1 to this many half-waves along the tube")
      .within(1, kMaxPattern)
      .type("N")
      .show_default();
  command
      .list("--measured", flags->measured,
            "Fit to measured hoop frequencies: waves around, half-waves along, frequency and its standard deviation")
      .type("N:M:HZ:STD,...");
  command.value("--fit", flags->unknowns, "Choose the parameters to fit to --measured")
      .one_of({"young", "wall", "both"})
      .show_default();
  add_output_flags(command, flags->output, report_extensions());
}

}  // namespace percuss::tools
