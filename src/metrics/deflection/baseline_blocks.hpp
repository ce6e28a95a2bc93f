#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace percuss::metrics {

/// Blocks of samples over which the baseline's error counts as constant: narrow beside the end of the rest, where the
/// impact begins, and wider with the distance from it.
struct BaselineBlocks {
  std::vector<double> begin_s, end_s;  // from the end of the rest, ascending
  std::vector<std::size_t> first;      // of each block, from the first sample at rest; one more than blocks
  std::size_t at_rest = 0;             // the blocks before the end of the rest

  std::size_t size() const { return begin_s.size(); }
  double middle_s(std::size_t block) const { return (begin_s[block] + end_s[block]) / 2; }
};
/// rest, moving: numbers of samples, both > 0.
BaselineBlocks baseline_blocks(std::size_t rest, std::size_t moving, double fs_Hz);

/// The covariances of the block means of 1/f noise with the one-sided power spectral density 1 (m/s²)²/f: a sum of
/// first-order processes whose rates are an octave apart,
///   S(f) ≈ ln 2 Σ_k 4 λ_k/(λ_k² + (2πf)²),  λ_k = 2^k λ_0                             (1)
/// from a tenth of the inverse of the record's length to half the sampling rate. Slower noise is a bias. theory (7.11)
Eigen::MatrixXd flicker_covariance(const BaselineBlocks& blocks, double fs_Hz);

/// The deflection at `t_s` that an acceleration of 1 m/s² in each block causes; 0 for blocks at rest. shapes [blocks].
Eigen::VectorXd deflection_by_block(const BaselineBlocks& blocks, double t_s, double highpass_corner_Hz);

}  // namespace percuss::metrics
