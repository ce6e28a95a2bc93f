#pragma once
#include <span>

namespace percuss::metrics {

/// The time of the first touch, between the samples, from the first sample.
struct ImpactOnset {
  double time_s = 0, std_s = 0;
};

/// Extrapolates the rise of an impact back to zero. A contact force begins as t^p: p = 1 for a spring, 3/2 for a Hertz
/// contact, 2 for a haversine. The acceleration of a struck mass follows the force; the acceleration of a long beam
/// begins as the half-derivative of the force. The samples from the quiet before the rise to a quarter of the first
/// extreme follow
///   x(t) = c (t − t₀)^p (1 + b u + d u²),   u = (t − t₀)/(t₁ − t₀),   0.5 ≤ p ≤ 2.5      (1)
/// with t₁ the time of the last of them, and b and d near zero (standard deviations 0.3 and 0.2). The time is the mean
/// of t₀ over all powers and coefficients, each with its probability; the standard deviation includes the uncertainty
/// of p.
/// Where the samples leap beyond a quarter of the extreme, the onset lies anywhere between two samples. Samples before
/// the rise that swing to the other side show an anti-alias filter: half of the swing then counts as noise, and half a
/// sample as part of the standard deviation.
/// theory (7.10)
/// `first` is the first sample that moves (motion_onset_s), `noise` the standard deviation of a sample.
ImpactOnset impact_onset(std::span<const double> x, double fs_Hz, std::size_t first, double noise);

}  // namespace percuss::metrics
