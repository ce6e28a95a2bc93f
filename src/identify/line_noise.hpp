#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/frf_set.hpp"

namespace percuss {

/// Deviation of the noise on each output's lines, (m/s²)/N, from how rough the FRF is between neighbouring lines:
/// |H(k) − (H(k−1) + H(k+1))/2|, median over all lines. The responses' noise is taken as even over the lines; that of
/// an FRF then goes as one over the force's amplitude. Where the force is not known the FRF's is taken as even.
class LineNoise {
 public:
  /// `set` must outlive this object.
  explicit LineNoise(const FrfSet& set);

  double at(std::size_t output, std::size_t line) const;
  /// As if even over the lines first … first + count − 1, [outputs].
  Eigen::VectorXd over(std::size_t first, std::size_t count) const;

 private:
  const FrfSet& set_;
  Eigen::VectorXd response_;  // [outputs]: m/s² summed over the samples, or (m/s²)/N without a force
};

/// Where an FRF is smooth its second difference is noise alone: power of the noise that each line's tells, which
/// scatters as a single line does. The first and last line tell nothing: 0. shape  [lines]
std::vector<double> roughness(std::span<const Complex> lines);

/// Power of the noise that the roughness of many lines tells, block by block of kNoiseBlock lines (the last one has the
/// rest as well): by their median, which skips resonances. The median over the blocks is that of all lines.
std::vector<double> block_noise(std::span<const double> rough);
double noise_power(std::span<const double> rough);
inline constexpr std::size_t kNoiseBlock = 64;

}  // namespace percuss
