#pragma once
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Sets with fewer points are not divided: a half would have too few FRFs to separate close modes.
inline constexpr std::size_t kMinDividedPoints = 8;

/// The poles that joint fits of either half of the points repeat, started at these poles. Resonances that move from
/// point to point are followed by several poles, at other places in either half. Both halves show every mode, where
/// such a division is found: on a grid, every second point may be a node line.
std::vector<Pole> poles_in_both_halves(const FrfDataset& set, const std::vector<Pole>& poles);

}  // namespace percuss::identify
