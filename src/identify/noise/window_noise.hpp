#pragma once
#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Variance of x(k) − (x(k−1) + x(k+1))/2 over the variance of x, for independent lines.
inline constexpr double kWhiteRoughness = 1.5;

/// The correlation that an exponential window causes between the noise of neighbouring spectral lines. Correlated lines
/// differ less from their neighbours than independent ones, and carry less information. All factors apply to
/// variances; they are 1 without a window.
/// theory (4.17), (4.18)
class WindowNoise {
 public:
  explicit WindowNoise(const FrfDataset& set);

  /// Variance of x(k) − (x(k−1) + x(k+1))/2 over the variance of x.
  double roughness() const;
  /// The largest factor: for a feature much broader than the correlation.
  double max_factor() const;
  /// The factors with equal weights of the lines: for a mode's frequency and damping ratio, for its residue with a
  /// known pole, and for what the deviation of the pole adds to the residue's variance.
  double of_pole(const Pole& pole) const;
  double of_residue(const Pole& pole) const;
  double of_residue_by_pole(const Pole& pole) const;

 private:
  double share(const Pole& pole) const;
  double factor(double of_share) const;

  double decay_per_s_;
  double fall_;  // the window's power falls by the factor exp(−fall_) over the record
};

}  // namespace percuss::identify
