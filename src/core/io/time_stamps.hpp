#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_dialect.hpp"

namespace percuss {
inline namespace core {

/// The sampling rate in Hz in a header line: "Sampling Rate(Hz),50" → 50, "fs = 25.6 kHz" → 25600, "dt [ms];0,5" →
/// 2000.
std::optional<double> stated_rate_Hz(std::string_view line, const CsvDialect& dialect);

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

enum class StampProblemKind {
  uneven,        // or too coarse, or too few
  jump,          // uneven, as the time jumps ahead by at least one and a half usual steps
  rates_differ,  // the rows are even, but their rates are not the same
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

/// The gaps of stamps that are even but for missing ones, as a file with lost lines has: every step is a whole number
/// of usual steps. Without `fs_Hz`, a usual step must be at least four units of the last digit: coarser stamps of a
/// rate just below one sample per unit look alike. `fs_Hz`: the rate, if it is stated; then none where even stamps of
/// this rate explain all. Empty where there is no gap, where more than a tenth of the stamps is missing, and where the
/// rest is uneven.
std::vector<StampGap> gaps_of_stamps(const TimeStamps& row, std::optional<double> fs_Hz = {});

/// The stamps with those of the gaps, which divide each gap evenly. `gaps` ascend.
std::vector<double> with_missing_stamps(std::span<const double> time_s, const std::vector<StampGap>& gaps);

/// The number with the fewest significant decimal digits in [low, high], 0 < low <= high.
double roundest_between(double low, double high);

}  // namespace core
}  // namespace percuss
