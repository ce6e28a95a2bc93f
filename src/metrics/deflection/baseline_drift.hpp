#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace percuss::metrics {

/// What the samples before an impact, where the structure rests, tell of the measuring chain: a bias that drifts, and
/// noise. The bias is bias + drift·t, t from the sample after the last of them.
struct BaselineEstimate {
  Eigen::Vector2d bias;        // m/s², m/s³
  Eigen::Matrix2d covariance;  // of both
  double noise_mps2 = 0;       // deviation of a sample
};

/// From the samples before the impact. Fewer than eight of them tell nothing: the bias is 0, give or take a tenth of
/// `unknown_mps2`.
BaselineEstimate baseline_estimate(std::span<const double> before_mps2, double fs_Hz, double unknown_mps2);

/// What a bias of 1 m/s² and a drift of 1 m/s³ become by integration with the high-pass undone:
///   w = b (t²/2 + ω_c t³/6) + d (t³/6 + ω_c t⁴/24)                                  (1)
/// and the same once differentiated for the velocity.
/// theory (7.3)
Eigen::Vector2d drifted_deflection_m(double t_s, double highpass_corner_Hz);
Eigen::Vector2d drifted_velocity_mps(double t_s, double highpass_corner_Hz);

/// What is left of the bias once it is known that a held structure swings about the place where it rested: two means of
/// the deflection, under Hann windows over the second and the last third, are zero but for what the windows let through
/// of the oscillation, and for the noise of the double integral.
struct ZeroMeanCorrection {
  Eigen::Vector2d bias;        // to be taken away in addition
  Eigen::Matrix2d covariance;  // of what remains
  bool held = false;           // false: the deflection contradicts it, or is too short to tell; nothing is taken away
};
/// deflection_m from integrate_twice of the samples after the rest, with its bias taken away; `rest` is that of bias.
/// theory (7.5)
ZeroMeanCorrection zero_mean_correction(std::span<const double> deflection_m, double fs_Hz, double highpass_corner_Hz,
                                        const BaselineEstimate& rest);

}  // namespace percuss::metrics
