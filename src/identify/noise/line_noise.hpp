#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Standard deviation of each FRF's noise, (m/s²)/N, from the FRF's roughness between neighbouring spectral lines: the
/// median of |H(k) − (H(k−1) + H(k+1))/2|. The response's noise is assumed white, so that the FRF's noise is inversely
/// proportional to the force's amplitude. Where the force is unknown, the FRF's noise is assumed white.
class LineNoise {
 public:
  /// `set` must outlive this object.
  explicit LineNoise(const FrfDataset& set);

  double at(std::size_t channel, std::size_t line) const;
  /// The noise over the lines first … first + count − 1, at the mean power of the force there, [channels].
  Eigen::VectorXd over(std::size_t first, std::size_t count) const;
  /// Noise power of an FRF around each spectral line, from the FRF alone; see local_noise.
  std::vector<double> local(std::size_t channel) const;

 private:
  const FrfDataset& set_;
  std::vector<std::vector<double>> blocks_;  // [channels] block_noise
  Eigen::VectorXd response_;                 // [channels]: m/s² (unscaled spectrum), or (m/s²)/N without a force
};

/// Noise power of each block of kNoiseBlock spectral lines; the last block holds the rest as well. Empty for fewer than
/// three lines. The second difference of a smooth FRF is pure noise, and the median excludes resonances. Every second
/// line suffices, because neighbouring differences share lines.
/// `roughness` is the variance of a second difference over the variance of a line (WindowNoise::roughness).
/// theory (4.1)
std::vector<double> block_noise(std::span<const Complex> lines, double roughness);
inline constexpr std::size_t kNoiseBlock = 64;

/// Noise power at each line: the median of the three blocks around it. shape  [lines]
std::vector<double> local_noise(std::span<const double> blocks, std::size_t lines);

}  // namespace percuss::identify
