#pragma once
#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Variance of x(k) − (x(k−1) + x(k+1))/2 over that of x, of independent lines.
inline constexpr double kWhiteRoughness = 1.5;

/// What an exponential window makes of white noise. It leaves the noise of a record's beginning, so that lines have
/// part of theirs in common: they differ less from their neighbours than their noise is large, and tell less than as
/// many independent ones would. Factors of variances, 1 without a window.
/// theory (4.17), (4.18)
class WindowNoise {
 public:
  explicit WindowNoise(const FrfDataset& set);

  /// Of x(k) − (x(k−1) + x(k+1))/2 over that of x.
  double roughness() const;
  /// What independent lines would tell over what these do, of a feature as broad as can be.
  double most() const;
  /// … of a mode's residue, and of its frequency and damping ratio, as lines of equal weight tell them.
  double of_residue(const Pole& pole) const;
  double of_pole(const Pole& pole) const;

 private:
  double share(const Pole& pole) const;

  double decay_per_s_;
  double fall_;  // of the window's power over the record, in nepers
};

}  // namespace percuss::identify
