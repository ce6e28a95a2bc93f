#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::identify {

/// A local maximum. Its prominence is its height above the higher of the two saddles to the next higher maxima.
struct Peak {
  std::size_t line = 0;
  double prominence = 0;
};

/// All local maxima of `level` in ascending order, in linear time. A flat maximum is represented by its middle. An end
/// is a maximum where it is above its only neighbour. Both ends are saddles of their own height.
std::vector<Peak> find_peaks(std::span<const double> level);

/// The same maxima where they are higher than `min_level`, at any prominence.
std::vector<std::size_t> maxima_above(std::span<const double> level, double min_level);

}  // namespace percuss::identify
