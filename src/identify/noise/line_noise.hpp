#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Deviation of the noise on each channel's lines, (m/s²)/N, from how rough the FRF is between neighbouring lines:
/// |H(k) − (H(k−1) + H(k+1))/2|, median over all lines. The responses' noise is taken as even over the lines; that of
/// an FRF then goes as one over the force's amplitude. Where the force is not known the FRF's is taken as even.
class LineNoise {
 public:
  /// `set` must outlive this object.
  explicit LineNoise(const FrfDataset& set);

  double at(std::size_t channel, std::size_t line) const;
  /// As if even over the lines first … first + count − 1, [channels].
  Eigen::VectorXd over(std::size_t first, std::size_t count) const;
  /// Power of an FRF's own noise around each line, whatever the force, as local_noise has it.
  std::vector<double> local(std::size_t channel) const;

 private:
  const FrfDataset& set_;
  std::vector<std::vector<double>> blocks_;  // [channels] block_noise
  Eigen::VectorXd response_;                 // [channels]: m/s² summed over the samples, or (m/s²)/N without a force
};

/// Power of the noise of each kNoiseBlock lines (the last block has the rest as well; none of fewer than three lines).
/// Where an FRF is smooth its second difference is noise alone, which scatters as a single line does; the median skips
/// resonances. Every second line tells nearly as much as all, neighbours having theirs in common.
/// theory (4.1)
/// `roughness` is that of a second difference over that of a line, as the lines have their noise in common.
std::vector<double> block_noise(std::span<const Complex> lines, double roughness);
inline constexpr std::size_t kNoiseBlock = 64;

/// Power of the noise on each line: of three blocks around it, the one in the middle. shape  [lines]
std::vector<double> local_noise(std::span<const double> blocks, std::size_t lines);

}  // namespace percuss::identify
