#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

namespace percuss::metrics {

/// The deflection due to a bias b and a drift d after integration, with the high-pass compensated:
///   w = b (t²/2 + ω_c t³/6) + d (t³/6 + ω_c t⁴/24)                                  (1)
/// Returns the two terms of (1) for b = 1 m/s² and d = 1 m/s³. The velocity terms are their derivatives.
/// theory (7.3)
Eigen::Vector2d drifted_deflection_m(double t_s, double highpass_corner_Hz);
Eigen::Vector2d drifted_velocity_mps(double t_s, double highpass_corner_Hz);

/// ∫K·w with a Hann window K (mean 1) over a part of the deflection w, and the contributions of noise and bias to it.
struct WindowMean {
  double mean_m = 0;
  Eigen::Vector2d by_bias;
  std::vector<double> by_noise;  // weight of each acceleration sample in the mean, s²
};
/// `from` and `to`: the ends of the window, as parts of the length of w.
WindowMean window_mean(std::span<const double> w, double fs_Hz, double highpass_corner_Hz, double from, double to);

/// The residual of a parabola fitted to a window: its amplitude, and its number of cycles within the window.
struct ParabolaResidual {
  double amplitude_m = 0, cycles = 0;
};
ParabolaResidual parabola_residual(std::span<const double> w, double from, double to);

/// An upper bound of the mean of an oscillation of this amplitude over a Hann window of `cycles` cycles (more than 1):
/// twice the envelope of the window's transform, because amplitude and phase of the oscillation are only estimated.
double hann_leakage_m(double amplitude_m, double cycles);

}  // namespace percuss::metrics
