#pragma once
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Sets with fewer points are not divided: a half would have too few FRFs to separate close modes.
inline constexpr std::size_t kMinDividedPoints = 8;

/// The poles that joint fits of either half of the points repeat, started at these poles. Several poles follow a
/// resonance that moves from point to point, and they lie at other places in either half. The points are divided so
/// that both halves show every mode, if such a division is found: on a grid, every second point may lie on a node line.
std::vector<Pole> poles_in_both_halves(const FrfDataset& set, const std::vector<Pole>& poles);

}  // namespace percuss::identify
