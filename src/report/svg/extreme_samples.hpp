#pragma once
#include <cstddef>
#include <vector>

namespace percuss::report {

/// Indices of the samples of a curve to draw, ascending: of each run of neighbours the lowest, the highest and one gap
/// (NaN) if any. About a thousand for long curves, all for short ones.
std::vector<std::size_t> extreme_samples(const std::vector<double>& y);

}  // namespace percuss::report
