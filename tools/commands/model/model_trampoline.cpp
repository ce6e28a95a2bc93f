#include <array>
#include <cmath>
#include <memory>

#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "cli/ranges.hpp"
#include "cli/report_output.hpp"
#include "commands/model/measured_ccor.hpp"
#include "commands/model/model_budget.hpp"
#include "commands/model/model_commands.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/parse_number.hpp"
#include "metrics/study/study_table.hpp"
#include "report/trampoline_report.hpp"

namespace percuss::tools {
namespace {

constexpr std::uint64_t kMaxTable_bytes = std::uint64_t{16} << 20U;

struct TrampolineFlags {
  std::string ball = "baseball", hoop = "100:25:10000";
  std::optional<double> ball_mass, stiffness, damping, stiffness_exponent, damping_exponent, barrel_mass,
      barrel_damping;
  double speed_mps = 60.80, extra_mass_kg = 0;
  std::optional<double> free_hoop_Hz, loaded_hoop_Hz;
  std::vector<std::string> ccor, hold, bats;
  std::vector<double> budget;
  OutputFlags output;
  bool keep_formulas = false;
};

model::Trampoline model_of(const TrampolineFlags& flags) {
  model::Trampoline m = flags.ball == "softball" ? model::softball_on_barrel() : model::baseball_on_barrel();
  m.ball_mass_kg = flags.ball_mass.value_or(m.ball_mass_kg);
  m.stiffness = flags.stiffness.value_or(m.stiffness);
  m.damping = flags.damping.value_or(m.damping);
  m.stiffness_exponent = flags.stiffness_exponent.value_or(m.stiffness_exponent);
  m.damping_exponent = flags.damping_exponent.value_or(m.damping_exponent);
  m.barrel_mass_kg = flags.barrel_mass.value_or(m.barrel_mass_kg);
  m.barrel_damping_Nspm = flags.barrel_damping.value_or(m.barrel_damping_Nspm);
  m.ball_speed_mps = flags.speed_mps;
  m.extra_mass_kg = flags.extra_mass_kg;
  if (!(m.damping_exponent < 1 + m.stiffness_exponent)) {
    throw OptionError({"b"}, "is not below 1 + a",
                      "give a smaller exponent; with this one the ball never leaves the barrel");
  }
  return m;
}

// Bats with a hoop frequency and a BBCOR.
std::vector<report::MeasuredBat> measured_bats(const std::vector<std::string>& paths) {
  if (paths.empty()) return {};
  metrics::StudyRows rows;
  for (const std::string& path : paths) rows.add(read_input(path, kMaxTable_bytes).view(), input_name(path));
  std::vector<report::MeasuredBat> out;
  for (const metrics::StudyBat& bat : rows.bats()) {
    const auto hoop_Hz = bat.value(metrics::StudyQuantity::hoop1), bbcor = bat.value(metrics::StudyQuantity::bbcor);
    if (hoop_Hz && bbcor) out.push_back({.id = bat.id, .hoop_Hz = *hoop_Hz, .bbcor = *bbcor});
  }
  if (out.empty()) {
    throw InputError("no bat with a first hoop frequency and a BBCOR", input_name(paths.front()),
                     "add hoop1_hz and bbcor, or besr, moi_oz_in2 and z_in", {"bats"});
  }
  return out;
}

// The exponents that the fit does not change: given by --hold, or by --a and --b. Stores the values of --hold in
// the flags of --a and --b.
model::HeldExponents held_exponents(TrampolineFlags& flags) {
  for (const std::string& text : flags.hold) {
    const std::size_t sign = text.find('=');
    const ParsedNumber number = parse_number(sign == std::string::npos ? "" : text.substr(sign + 1), false);
    const std::string name = text.substr(0, sign);
    if ((name != "a" && name != "b") || number.problem != NumberProblem::none || number.value < 0) {
      throw OptionError::wrong_value("hold", text, "give a=VALUE or b=VALUE with a value of 0 or more");
    }
    std::optional<double>& exponent = name == "a" ? flags.stiffness_exponent : flags.damping_exponent;
    if (exponent && *exponent != number.value)
      throw OptionError({"hold"}, "gives a second value of " + name, "give one of them", {name});
    exponent = number.value;
  }
  if (!flags.hold.empty() && flags.ccor.empty()) {
    throw OptionError({"hold"}, "holds an exponent of a fit, but nothing is fitted", "give measured CCOR",
                      {"fit_ccor"});
  }
  return {.stiffness = flags.stiffness_exponent.has_value(), .damping = flags.damping_exponent.has_value()};
}

std::optional<double> mass_from_shift(const TrampolineFlags& flags) {
  if (!flags.free_hoop_Hz && !flags.loaded_hoop_Hz) return {};
  const char* remedy = "give both frequencies, the loaded one lower, and the extra mass";
  if (!flags.free_hoop_Hz || !flags.loaded_hoop_Hz)
    throw OptionError({"free_hoop", "loaded_hoop"}, "must be given together", remedy, {"extra_mass"});
  if (!(*flags.free_hoop_Hz > *flags.loaded_hoop_Hz && flags.extra_mass_kg > 0)) {
    throw OptionError({"loaded_hoop"}, "must be below the free frequency, with an extra mass above 0", remedy,
                      {"extra_mass"});
  }
  return model::modal_mass_kg(flags.extra_mass_kg, *flags.free_hoop_Hz, *flags.loaded_hoop_Hz);
}

int model_trampoline(TrampolineFlags flags) {
  check_report_outputs(flags.output);
  const ModelBudget budget(flags.budget, "model trampoline");
  const model::HeldExponents held = held_exponents(flags);
  model::Trampoline model = model_of(flags);
  const Range hoop = parse_range("hoop", flags.hoop);
  if (!(hoop.low >= 1)) throw OptionError({"hoop"}, "starts below 1 Hz", "give LO:STEP:HI, such as 100:25:10000");
  report::TrampolineExtras extras{.fitted = {},
                                  .modal_mass_kg = mass_from_shift(flags),
                                  .bats = measured_bats(flags.bats),
                                  .formulas = csv_formulas(flags.keep_formulas)};
  if (!flags.ccor.empty()) {
    model::FittedExponents fitted{.measured = measured_ccor(flags.ccor), .fit = {}};
    fitted.fit = model::fit_exponents(model, fitted.measured, held);
    model = model::with_exponents(model, fitted.fit.exponents());
    extras.fitted = std::move(fitted);
  }
  return show_report(report::trampoline_report(model, hoop.values(), extras), flags.output, flags.bats);
}

void add_constants(Command& command, TrampolineFlags& flags) {
  const std::string previous = command.heading("Constants (default: from --ball)");
  command.value("--m1", flags.ball_mass, "Set the mass of the ball").above_zero().type("KG");
  command.value("--k1", flags.stiffness, "Set the stiffness of the ball, N/m^(1+a)").above_zero().type("K1");
  command.value("--c1", flags.damping, "Set the damping of the ball, N s/m^(1+b)").not_negative().type("C1");
  command.value("--a", flags.stiffness_exponent, "Set the exponent of the ball's stiffness").not_negative().type("A");
  command.value("--b", flags.damping_exponent, "Set the exponent of the ball's damping, below 1 + a")
      .not_negative()
      .type("B");
  command.value("--m2", flags.barrel_mass, "Set the effective mass of the barrel").above_zero().type("KG");
  command
      .value("--c2", flags.barrel_damping,
             "Set the damping of the barrel; for a baseball, Sutton (2010) has 90.5 in a script and 100 in a table")
      .not_negative()
      .type("N*S/M");
  command.heading(previous);
}

}  // namespace

void add_model_trampoline(CommandLine& line) {
  auto flags = line.values<TrampolineFlags>();
  Command command = line.command("model trampoline",
                                 "Predict the COR of a ball on a hollow barrel as a function of its hoop frequency",
                                 [flags] { return model_trampoline(*flags); });
  command.about(
      "Models the ball and the wall of a hollow barrel as two masses with springs and dampers. Reports the COR as a "
      "function of the hoop frequency of the barrel, and the frequency of the largest COR.");
  command.example("percuss model trampoline --c2 100 -o cor.svg", "Draw the COR against the hoop frequency");
  command.example("percuss model trampoline --ball softball --speed 49 --hoop 500:50:3000",
                  "Model a softball at 49 m/s");
  command.example(
      "percuss model trampoline --fit-ccor 26.8:0.519:0.004,40.2:0.502:0.004,51.4:0.491:0.004 --hold a=0.6495",
      "Fit b to measured CCOR for a known a");
  command.example("percuss study --example > bats.csv; percuss model trampoline --bats bats.csv -o cor.svg -o cor.csv",
                  "Draw measured bats beside the curve, and write the curve and the bats as a table");
  command.value("--ball", flags->ball, "Use the constants of this ball")
      .one_of({"baseball", "softball"})
      .show_default();
  command.value("--speed", flags->speed_mps, "Set the speed of the ball towards the barrel")
      .above_zero()
      .type("M/S")
      .show_default();
  command.value("--hoop", flags->hoop, "Set the hoop frequencies in Hz").type("LO:STEP:HI").show_default();
  command
      .value("--extra-mass", flags->extra_mass_kg, "Set an extra mass that moves with the barrel without stiffening it")
      .not_negative()
      .type("KG")
      .show_default();
  command
      .value("--free-hoop", flags->free_hoop_Hz, "Set the hoop frequency without the extra mass; needs --loaded-hoop")
      .above_zero()
      .type("HZ");
  command
      .value("--loaded-hoop", flags->loaded_hoop_Hz,
             "Set the hoop frequency with the extra mass; gives the modal mass from the shift against --free-hoop")
      .above_zero()
      .type("HZ");
  command
      .list("--fit-ccor", flags->ccor,
            "Fit a and b to measured CCOR first: speed in m/s, COR and its standard deviation; or a file of such lines")
      .type("SPEED:COR:STD,...");
  command
      .list("--hold", flags->hold,
            "Hold an exponent in the fit, such as a=0.6495; with --fit-ccor, the options --a and --b also hold their "
            "exponents")
      .type("NAME=VALUE,...");
  command
      .repeatable("--bats", flags->bats,
                  "Compare with the BBCOR of bats at their first hoop frequency: tables and documents as for percuss "
                  "study (repeatable)")
      .type("FILE");
  add_constants(command, *flags);
  add_model_budget(command, flags->budget);
  add_output_flags(command, flags->output, report_extensions());
  add_formula_flag(command, flags->keep_formulas);
}

}  // namespace percuss::tools
