#include "outcome.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <utility>

#include "core/error.hpp"

namespace percuss::stress {
namespace {

// The exit codes that README.md and the manual list.
constexpr int kInternal = 1, kBadInput = 3, kImpossible = 4;

bool usable_std(double x) { return std::isfinite(x) && x > 0; }

bool usable(const identify::Residue& residue) {
  return std::isfinite(residue.value.real()) && std::isfinite(residue.value.imag()) && std::isfinite(residue.std) &&
         residue.std >= 0 && std::isfinite(residue.relative_std);
}

void note_findings(const pipeline::Analysis& analysis, std::set<std::string>& said) {
  for (const pipeline::AnalysedHit& hit : analysis.hits()) {
    for (const acquire::Finding& finding : hit.hit.findings) said.insert(name_of(finding.code));
  }
}

// Reads the frequencies from "no mode models these peaks: 1518 Hz (-23 dB), 1521.2 Hz (-25 dB). …".
std::vector<double> frequencies_of(const std::string& message) {
  std::vector<double> freq_Hz;
  static const std::regex kPlace("([0-9.e+]+) Hz \\(");
  for (std::sregex_iterator it(message.begin(), message.end(), kPlace), end; it != end; ++it)
    freq_Hz.push_back(std::stod((*it)[1]));
  return freq_Hz;
}

void note_warnings(const pipeline::Analysis& analysis, CommandResult& outcome) {
  for (const pipeline::Warning& warning : analysis.warnings()) {
    outcome.said.insert(warning.code);
    if (warning.code == "unclaimed_peaks") outcome.unexplained_Hz = frequencies_of(warning.message);
  }
}

}  // namespace

CommandResult analyse(acquire::Record record, const pipeline::AnalysisOptions& options) {
  CommandResult outcome;
  try {
    const pipeline::Analysis analysis(std::move(record), options);
    note_findings(analysis, outcome.said);
    if (analysis.possible()) {
      outcome.modes = analysis.modes();
      analysis.classifications();
      outcome.df_Hz = analysis.lines().df_Hz();
    } else {
      outcome.exit_code = kImpossible;
    }
    note_warnings(analysis, outcome);
  } catch (const InputError& e) {
    outcome.exit_code = kBadInput;
    outcome.message = e.what();
  } catch (const std::exception& e) {
    outcome.exit_code = kInternal;
    outcome.message = e.what();
  }
  return outcome;
}

std::string unusable_number(const std::vector<identify::Mode>& modes) {
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const identify::Mode& mode = modes[m];
    const auto named = [m](const char* what) { return fmt::format("{} of mode {} is not usable", what, m); };
    if (!(std::isfinite(mode.pole.freq_Hz) && mode.pole.freq_Hz > 0)) return named("frequency");
    if (!(std::isfinite(mode.pole.damping_ratio) && mode.pole.damping_ratio > 0)) return named("damping ratio");
    if (!usable_std(mode.freq_std_Hz)) return named("standard deviation of the frequency");
    if (!usable_std(mode.damping_std)) return named("standard deviation of the damping ratio");
    for (const identify::Residue& residue : mode.residues) {
      if (!usable(residue)) return named("residue");
    }
  }
  return {};
}

}  // namespace percuss::stress
