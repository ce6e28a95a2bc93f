#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check.hpp"
#include "outcome.hpp"
#include "synth/synthesise.hpp"

namespace percuss::stress {

/// What rounding is worth: a pole's error as a part of its distance |s| from the origin. Frequency (relative) and
/// damping ratio (absolute) are its two components in that unit. Synthetic samples are exact to 1e-12 of the peak and
/// their filter to 1e-11; a pole magnifies that by what its lines tell of it, at worst a hundred times here.
inline constexpr double kRoundingOfPole = 1e-9;
/// Reported deviations that an answer may be off: beyond, it is wrong and sure of itself.
inline constexpr double kMostSigmas = 5;

enum class Demand {
  as_the_bound_allows,  // every mode whose Cramér–Rao bound says that it can be told (Resolvable)
  all,
  none  // whatever is reported must be right
};

struct Expectation {
  std::string text;  // for the table; empty: made from the rest
  Demand demand = Demand::as_the_bound_allows;
  std::vector<std::string> says;  // codes that must be among findings and warnings
  std::string warns;              // a code that makes up for errors beyond the deviations: they do not hold
  int exit_code = 0;
  std::string reason;                   // of another exit code: a finding's code, or part of the message
  std::vector<std::string> or_refused;  // one of these reasons (exit code 3 or 4) is as good as modes
  std::optional<double> freq_relative, damping_absolute;  // accuracy that every mode must have, warned or not
};
std::string text_of(const Expectation& expected);

/// A mode of the structure, and what can be known of it.
struct TrueMode {
  identify::Pole pole;
  double freq_bound_Hz = 0, damping_bound = 0;  // Cramér–Rao; 0 without noise
};

/// Modes in the band that some sensor sees, ascending.
std::vector<TrueMode> true_modes(const synth::Truth& truth);

/// Holds an outcome against the truth.
///   resolvable  a mode can be told when its bound on the damping is a tenth of the damping; two modes can be told
///   apart
///               when ten times the bound on their distance lies between them. Where not, one mode within their range
///               is right as well, and for a mode that cannot be told none.
///   wrong       more than kMostSigmas off, a mode that is none, one that must be found and is not, unless a warning
///               of unclaimed peaks names its place.
Result judge(const CommandResult& outcome, const std::vector<TrueMode>& truth, const Expectation& expected);

}  // namespace percuss::stress
