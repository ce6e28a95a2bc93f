#pragma once
#include <cstddef>
#include <span>

#include "core/math/statistics.hpp"

namespace percuss::acquire {

/// The smallest change from one sample to the next: the recorder's resolution, as far as these samples tell it. 0 for
/// a constant.
double resolution_of(std::span<const double> x);

/// Number of samples at the stretch's extreme values where they look like the recorder's rail, else 0. Either three or
/// more equal ones stand in a row, with a neighbour further away than a smooth peak's would be at this resolution; or
/// several tops end at the same value with hardly a sample just below it, where a swing spends most of its time. An
/// extreme at which the signal rests is no rail: a signal to one side only stands there before and after. `blocks` are
/// block_extremes of x by kClippingBlock; `around`, longer than x, tells the resolution.
inline constexpr std::size_t kClippingBlock = 512;
std::size_t count_clipped_samples(std::span<const double> x, std::span<const Extremes> blocks,
                                  std::span<const double> around, double rest);

}  // namespace percuss::acquire
