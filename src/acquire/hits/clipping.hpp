#pragma once
#include <cstddef>
#include <span>

#include "core/math/statistics.hpp"

namespace percuss::acquire {

/// The smallest change other than 0 from one sample to the next: an estimate of the recorder's resolution. 0 for a
/// constant signal.
double resolution_of(std::span<const double> x);

inline constexpr std::size_t kClippingBlock = 512;

/// The number of samples at the extreme values of x when these look like clipping, otherwise 0. Two patterns count:
/// - at least three equal samples in a row, beside which the signal falls by more steps of the resolution than beside a
///   smooth peak;
/// - several peaks that end at the same value, with few samples just below it. An oscillation that is not clipped has
///   many samples there.
/// An extreme equal to `rest` is not clipping: a one-sided signal rests there before and after.
/// `blocks` are block_extremes of x by kClippingBlock. `around` contains x; the resolution is found in it.
std::size_t count_clipped_samples(std::span<const double> x, std::span<const Extremes> blocks,
                                  std::span<const double> around, double rest);

/// Whether a pulse of few samples is clipped: its two largest samples are equal and neighbours, although the samples
/// beside them lie lower by 1000 steps of the resolution or more, and not equally low. Rounding makes the two largest
/// samples of a smooth pulse equal with a probability of the resolution over that distance. `around` as above.
bool is_flat_pair(std::span<const double> pulse, std::span<const double> around);

}  // namespace percuss::acquire
