#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace percuss::acquire {

/// sign · x after a running mean over 2h + 1 samples. It reduces the noise and the ringing near fs/2. Pulses as long as
/// the main pulse remain.
std::vector<double> smoothed(std::span<const double> x, double sign, std::size_t h);

/// The samples [first, end) around `peak` where sign · x stays above `level`.
std::pair<std::size_t, std::size_t> above(std::span<const double> x, double sign, std::size_t peak, double level);

/// The width in samples, interpolated, over which sign · x stays above half its value at `peak`.
double width_at_half_peak(std::span<const double> x, double sign, std::size_t peak);

}  // namespace percuss::acquire
