#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::identify {

/// A local maximum and how far it stands above the higher of the two saddles that part it from anything higher.
struct Peak {
  std::size_t line = 0;
  double prominence = 0;
};

/// Every local maximum of `level` (the middle of a flat one), in ascending order, in linear time. A maximum at either
/// end counts when it stands above its only neighbour. The ends are saddles of their own height.
std::vector<Peak> find_peaks(std::span<const double> level);

/// Those of the same maxima that are higher than `least`, whatever their prominence.
std::vector<std::size_t> maxima_above(std::span<const double> level, double least);

}  // namespace percuss::identify
