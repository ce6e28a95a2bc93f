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

/// The reason why time stamps give no rate, and the place of the worst stamp.
struct StampProblem {
  std::string text;
  std::size_t row = 0, at = 0;  // `at`: index of the stamp in its row
  bool rates_differ = false;    // the rows are even, but their rates are not the same
};

/// The rate of evenly spaced stamps:
///   fs = Σ (n − 1) / Σ (t_last − t_first)   over rows                              (1)
/// The result is the number with the fewest digits within the limits from the rounding of the stamps.
/// errors  Returns nothing and sets `problem`: stamps that are uneven beyond their rounding, do not rise, are too
/// coarse to give the rate to 5e-4, or are fewer than two; rows whose rates differ by more than 1e-3.
std::optional<StampedRate> rate_of_time_stamps(std::span<const TimeStamps> rows, StampProblem& problem);

/// The number with the fewest significant decimal digits in [low, high], 0 < low <= high.
double roundest_between(double low, double high);

}  // namespace core
}  // namespace percuss
