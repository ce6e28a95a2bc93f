#pragma once
#include <algorithm>
#include <span>
#include <vector>

namespace percuss {
inline namespace core {

/// Median of the values (mean of the middle two for an even count); 0 for none.
double median(std::vector<double> values);

/// Standard deviation of Gaussian noise from the median absolute deviation (× 1.4826, [2] in docs/theory/sources.md).
/// Pulses in a few per cent of the samples hardly raise it; in less than half of them, they raise it by a factor that
/// does not depend on their size. 0 for none.
/// theory (1.1)
double robust_std(std::vector<double> values);

/// Median and robust_std in the time of robust_std.
struct Spread {
  double median = 0, robust_std = 0;
};
Spread spread_of(std::vector<double> values);

/// Every n-th value, with n such that at most 2·`enough` values remain. Their median resists rare values like the
/// median of all values.
std::vector<double> subsampled(std::span<const double> values, std::size_t enough);

/// Smallest and largest value; both 0 for none.
struct Extremes {
  double low = 0, high = 0;
  double max_distance_from(double centre) const { return std::max(high - centre, centre - low); }
};
Extremes extremes_of(std::span<const double> values);
/// The extremes of each block of `block` values; the last block may be shorter.
std::vector<Extremes> block_extremes(std::span<const double> values, std::size_t block);
Extremes extremes_of(std::span<const Extremes> blocks);

/// √(Σx²/n); 0 for none.
double rms(std::span<const double> values);
/// The same of the deviations from the mean.
double rms_about_mean(std::span<const double> values);

}  // namespace core
}  // namespace percuss
