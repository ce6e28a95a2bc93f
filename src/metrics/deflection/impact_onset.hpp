#pragma once
#include <span>

namespace percuss::metrics {

/// The time of the first touch, between the samples, from the first sample.
struct ImpactOnset {
  double time_s = 0, std_s = 0;
};

/// Extrapolates the rise of an impact back to zero. A contact force begins as t^p: p = 3/2 for a Hertz contact, 1 for a
/// spring. The acceleration of a struck mass follows the force. The acceleration of a long beam begins as the
/// half-derivative of the force, so p = 1 for a Hertz contact. x^(1/p) is a straight line in time, fitted to the
/// samples between the noise and a quarter of the first extreme:
///   x(t) = c (t − t₀)^p,   t₀ = (t₀(1) + t₀(3/2))/2                                     (1)
/// The standard deviation includes the noise of the samples, and half of the difference between both powers. A rise
/// shorter than two samples leaves the onset anywhere between two samples.
/// theory (7.10)
/// `first` is the first sample that moves (motion_onset_s), `noise` the standard deviation of a sample.
ImpactOnset impact_onset(std::span<const double> x, double fs_Hz, std::size_t first, double noise);

}  // namespace percuss::metrics
