#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::pipeline {

/// Level of the highest frequencies of a signal along time, block by block. It is the level of the differences of order
/// kDifferenceOrder, scaled so that white noise keeps its standard deviation. The differences suppress oscillations
/// that are slow against the sampling rate; noise, jumps and single wrong samples remain.
struct DifferenceProfile {
  std::size_t first = 0;             // sample of the signal at which the first block begins
  std::vector<double> rms, largest;  // [blocks]
  std::vector<std::size_t> at;       // [blocks] sample of `largest`, the middle of its difference
};
inline constexpr std::size_t kDifferenceOrder = 12;
inline constexpr std::size_t kDifferenceBlock = 256;

/// The profile of x from `first` on; blocks that are not whole are left out.
DifferenceProfile difference_profile(std::span<const double> x, std::size_t first);

/// Standard deviation of the differences of x, as in the profile; nothing for fewer than 2·kDifferenceOrder samples.
std::optional<double> difference_rms(std::span<const double> x);

/// Samples at which the differences stand out of their surroundings and exceed `least`, the clearest first, at most
/// `most`.
std::vector<std::size_t> outstanding_samples(const DifferenceProfile& profile, std::size_t most, double least);

}  // namespace percuss::pipeline
