#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/live/session_quality.hpp"

namespace percuss::pipeline {

/// A demand on the ± of a frequency: "hoop1<0.05Hz", "mode 3 < 0.01 %".
struct PrecisionGoal {
  identify::ModeType type = identify::ModeType::unknown;  // unknown: `number` counts all modes by frequency
  int number = 1;                                         // from 1
  double limit = 0;                                       // Hz; of the frequency, as a part, if `relative`
  bool relative = false;

  /// "hoop 1 < 0.05 Hz".
  std::string text() const;
};

/// One goal, or several with commas between them. Blanks do not matter.
/// errors  InputError with the option "until": the part that is not understood, and what is allowed.
std::vector<PrecisionGoal> parse_goals(std::string_view text);

/// The mode that a goal names, of several with one name (a split pair) the one that is farthest from the limit; nothing
/// while none is found.
std::optional<std::size_t> mode_of(const PrecisionGoal& goal, const SessionQuality& quality);
double limit_Hz(const PrecisionGoal& goal, const LiveMode& mode);
/// Fewer do not show the scatter between blows.
inline constexpr std::size_t kMinBlowsForGoals = 3;
/// Whether a goal is met by all modes that it names, and by three blows or more.
bool is_met(const PrecisionGoal& goal, const SessionQuality& quality);
bool all_met(const std::vector<PrecisionGoal>& goals, const SessionQuality& quality);

}  // namespace percuss::pipeline
