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

/// All local maxima of `level` in ascending order, in linear time. A flat maximum is represented by its middle. On a
/// side without a higher maximum, the saddle is the lowest value up to the end. An end is a maximum where it is above
/// its only neighbour. Such an end is its own saddle, so its prominence is 0.
std::vector<Peak> find_peaks(std::span<const double> level);

/// The same maxima where they are higher than `min_level`, at any prominence.
std::vector<std::size_t> maxima_above(std::span<const double> level, double min_level);

}  // namespace percuss::identify
