#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check.hpp"
#include "outcome.hpp"
#include "synth/synthesise.hpp"

namespace percuss::stress {

/// The error of a pole due to rounding, relative to its distance |s| from the origin. Its components are the relative
/// error of the frequency and the absolute error of the damping ratio. Synthetic samples are exact to 1e-12 of the peak
/// and their filter to 1e-11. The condition number of a pole multiplies these errors by at most a hundred here.
inline constexpr double kRoundingOfPole = 1e-9;
/// The largest accepted error, in units of the reported standard deviation. A larger error without a warning is a
/// failure: a normal error exceeds this limit once in 1.7 million.
inline constexpr double kMaxSigmas = 5;

enum class Demand {
  as_the_bound_allows,  // every resolvable mode, by its Cramér–Rao bound (judge)
  all,
  none  // every reported mode must be right
};

struct Expectation {
  std::string text;  // for the table; empty: composed from the other members
  Demand demand = Demand::as_the_bound_allows;
  std::vector<std::string> says;  // codes that must be among the findings and warnings
  /// A code that excuses errors beyond kMaxSigmas, spurious modes and, without freq_relative, missing modes.
  std::string warns;
  int exit_code = 0;
  std::string reason;                   // for an exit code above 0: a finding's code or a part of the message
  std::vector<std::string> or_refused;  // one of these reasons (exit code 3 or 4) is as acceptable as modes
  std::optional<double> freq_relative, damping_absolute;  // required accuracy of every mode, with or without a warning
};
std::string text_of(const Expectation& expected);

/// A mode of the structure, with its Cramér–Rao bounds.
struct TrueMode {
  identify::Pole pole;
  double freq_bound_Hz = 0, damping_bound = 0;  // Cramér–Rao; 0 without noise
};

/// The modes in the band that a sensor measures, ascending.
std::vector<TrueMode> true_modes(const synth::Truth& truth);

/// Compares an outcome with the truth.
///   resolvable  A mode is resolvable if the bound of its damping is at most a tenth of the damping. Two modes are
///               separable if their distance exceeds ten times the sum of their bounds. One mode within the range
///               of inseparable modes is also right. A mode that is not resolvable may be missing.
///   wrong       An error above kMaxSigmas, a spurious mode, or a missing resolvable mode. A missing mode is excused
///               if the warning of unmodelled peaks names its frequency.
Result judge(const CommandResult& outcome, const std::vector<TrueMode>& truth, const Expectation& expected);

}  // namespace percuss::stress
