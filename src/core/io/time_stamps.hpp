#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_dialect.hpp"

namespace percuss::inline core {

/// The rate in Hz that a header line states: "Sampling Rate(Hz),50" → 50, "fs = 25.6 kHz" → 25600, "dt [ms];0,5" →
/// 2000.
std::optional<double> stated_rate_Hz(std::string_view line, const CsvDialect& dialect);

/// Time stamps of one row, as written.
struct TimeStamps {
  std::span<const double> time_s;
  double resolution_s = 0;  // one unit of the last digit written
};

struct StampedRate {
  double fs_Hz = 0;
  double lowest_Hz = 0, highest_Hz = 0;  // what the rounding of the stamps leaves open
  std::string note;                      // empty when the stamps give the rate exactly
};

/// The rate of evenly spaced stamps:
///   fs = Σ (n − 1) / Σ (t_last − t_first)   over rows                              (1)
/// and then the roundest number between what the rounding of the stamps leaves open.
/// errors  std::optional is empty and `problem` says why: stamps that are uneven beyond their rounding, do not rise,
/// are too coarse to tell the rate to 5e-4, or are fewer than two. `at` is the offending stamp, counted over all rows.
struct StampProblem {
  std::string text;
  std::size_t row = 0, at = 0;
};
std::optional<StampedRate> rate_of_time_stamps(std::span<const TimeStamps> rows, StampProblem& problem);

/// The number with the fewest significant decimal digits in [low, high], 0 < low <= high.
double roundest_between(double low, double high);

}  // namespace percuss::inline core
