#pragma once
#include <span>
#include <vector>

namespace percuss {

/// Median of the values (mean of the middle two for an even count); 0 for none.
double median(std::vector<double> values);

/// Standard deviation of Gaussian noise as the median absolute deviation from the median tells it (× 1.4826, [2] in
/// docs/sources.md): unmoved by pulses that fill less than half of the samples. 0 for none.
double robust_std(std::vector<double> values);

/// √(Σx²/n); 0 for none.
double rms(std::span<const double> values);

}  // namespace percuss
