#pragma once
#include <cstddef>
#include <vector>

namespace percuss::report {

/// Indices of the samples of a curve to draw, ascending: of each run of neighbours the lowest, the highest and one gap
/// (NaN) if any. About a thousand indices for 1500 samples or more; all for fewer.
std::vector<std::size_t> extreme_samples(const std::vector<double>& y);

}  // namespace percuss::report
