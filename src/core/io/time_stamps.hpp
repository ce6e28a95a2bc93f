#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace percuss {
inline namespace core {

/// Time stamps of one row, as written.
struct TimeStamps {
  std::span<const double> time_s;
  double resolution_s = 0;  // one unit of the last written digit
};

struct StampedRate {
  double fs_Hz = 0;
  double lowest_Hz = 0, highest_Hz = 0;  // limits from the rounding of the stamps
  std::string note;  // says that the stamps are rounded; empty if fs_Hz differs from (1) by at most 1e-6 of it
};
/// The largest distance of fs_Hz from a rate within the limits, relative to fs_Hz.
inline double largest_error_of(const StampedRate& rate) {
  return std::max(rate.fs_Hz - rate.lowest_Hz, rate.highest_Hz - rate.fs_Hz) / rate.fs_Hz;
}

enum class StampProblemKind {
  uneven,        // uneven, too coarse or too few stamps
  jump,          // uneven, because a step is at least one and a half usual steps long
  rates_differ,  // the stamps of each row are even, but the rates of the rows differ
};

/// The reason why time stamps give no rate, and the place of the worst stamp.
struct StampProblem {
  std::string text;
  std::size_t row = 0, at = 0;  // `at`: index of the stamp in its row
  StampProblemKind kind = StampProblemKind::uneven;
};

/// Stamps that are missing from a row.
struct StampGap {
  std::size_t at = 0;     // index of the stamp after the gap
  std::size_t count = 0;  // missing stamps before it
};

/// The rate of evenly spaced stamps:
///   fs = Σ (n − 1) / Σ (t_last − t_first)   over rows                              (1)
/// The result is the number with the fewest digits within the limits from the rounding of the stamps.
/// errors  Returns nothing and sets `problem`: stamps that are uneven beyond their rounding, do not rise, are too
/// coarse to give the rate to 5e-4, or are fewer than two; rows whose rates differ by more than 1e-3.
std::optional<StampedRate> rate_of_time_stamps(std::span<const TimeStamps> rows, StampProblem& problem);

/// The gaps in a row from which lines were lost: every step is a whole number of usual steps. `fs_Hz`: the rate, if it
/// is stated; there is no gap if even stamps of this rate explain all stamps. Without it, a usual step must be at least
/// four units of the last digit, because coarser stamps with a gap look like stamps of a rate just below one sample per
/// unit. Empty if more than a tenth of the stamps is missing, or if the stamps are uneven in another way.
std::vector<StampGap> gaps_of_stamps(const TimeStamps& row, std::optional<double> fs_Hz = {});

/// The stamps, with the missing ones inserted so that they divide each gap evenly. `gaps` ascend.
std::vector<double> with_missing_stamps(std::span<const double> time_s, const std::vector<StampGap>& gaps);

/// The number with the fewest significant decimal digits in [low, high], 0 < low <= high.
double roundest_between(double low, double high);

}  // namespace core
}  // namespace percuss
