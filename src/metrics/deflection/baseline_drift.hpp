#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace percuss::metrics {

/// The bias and the noise of the measuring chain, from the samples before an impact, where the structure rests. The
/// acceleration's error is bias + drift·t; t counts from the first sample after those samples.
struct BaselineEstimate {
  Eigen::Vector2d bias;        // m/s², m/s³
  Eigen::Matrix2d covariance;  // of both
  /// The standard deviation of a sample of white noise that is as strong as the measured noise is at low frequencies,
  /// which double integration amplifies.
  double noise_mps2 = 0;
  std::vector<double> residual_mps2{};  // the samples less bias and drift; empty with fewer than eight of them
};

/// Estimates bias and noise from the samples before the impact. With fewer than eight samples the bias is 0, with a
/// standard deviation of a tenth of `rms_mps2`, the RMS of the signal.
BaselineEstimate baseline_estimate(std::span<const double> before_mps2, double fs_Hz, double rms_mps2);

/// The remaining bias of a held structure, which oscillates about its position of rest. Two means of the deflection are
/// taken, with Hann windows over the middle and the last third. Without bias, only window leakage of the oscillation
/// and noise of the double integral keep them from zero.
struct ZeroMeanCorrection {
  Eigen::Vector2d bias;        // to subtract in addition
  Eigen::Matrix2d covariance;  // of the remaining bias
  bool held = false;           // false: the deflection contradicts zero means or is too short; nothing is subtracted
};
/// deflection_m: integrate_twice of the acceleration from the end of the samples at rest, after subtraction of the bias
/// and drift in `rest`. For a free body, its rigid-body deflection is subtracted as well.
/// theory (7.5)
ZeroMeanCorrection zero_mean_correction(std::span<const double> deflection_m, double fs_Hz, double highpass_corner_Hz,
                                        const BaselineEstimate& rest);

}  // namespace percuss::metrics
