#pragma once
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Sets with fewer points are not divided: a half would have too few FRFs to separate close modes.
inline constexpr std::size_t kMinDividedPoints = 8;

/// The poles that the data confirm: the points are divided into two halves, each half is fitted jointly from `poles`,
/// and a pole is kept if both fits end near each other. A resonance whose frequency changes from point to point is
/// described by several poles, and these differ between the halves. The points are divided so that both halves show
/// every mode, if such a division is found: on a grid, every second point may lie on a node line.
std::vector<Pole> poles_in_both_halves(const FrfDataset& set, const std::vector<Pole>& poles);

}  // namespace percuss::identify
