#include "metrics/deflection/window_mean.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace percuss::metrics {
namespace {

constexpr double kLeakageMargin = 2;  // the oscillation's amplitude and phase are only estimated

double hann(double x) { return x <= 0 || x >= 1 ? 0 : 1 - std::cos(kTwoPi * x); }  // mean 1

}  // namespace

Eigen::Vector2d drifted_deflection_m(double t_s, double highpass_corner_Hz) {
  const double corner = kTwoPi * highpass_corner_Hz, t2 = t_s * t_s;
  return {t2 / 2 + corner * t2 * t_s / 6, t2 * t_s / 6 + corner * t2 * t2 / 24};  // (1)
}

Eigen::Vector2d drifted_velocity_mps(double t_s, double highpass_corner_Hz) {
  const double corner = kTwoPi * highpass_corner_Hz, t2 = t_s * t_s;
  return {t_s + corner * t2 / 2, t2 / 2 + corner * t2 * t_s / 6};
}

WindowMean window_mean(std::span<const double> w, double fs_Hz, double highpass_corner_Hz, double from, double to) {
  const std::size_t n = w.size();
  const double dt_s = 1 / fs_Hz, length = static_cast<double>(n);
  WindowMean out{.by_bias = Eigen::Vector2d::Zero(), .by_noise = std::vector<double>(n)};
  std::vector<double> kernel(n);
  const auto begin = static_cast<std::size_t>(std::max(0.0, std::floor(from * length)));
  const std::size_t end = std::min(n, static_cast<std::size_t>(std::max(0.0, std::ceil(to * length))) + 1);
  for (std::size_t i = begin; i < end; ++i)
    kernel[i] = hann((static_cast<double>(i) / length - from) / (to - from)) / ((to - from) * length);
  for (std::size_t i = begin; i < end; ++i) {
    out.mean_m += kernel[i] * w[i];
    out.by_bias += kernel[i] * drifted_deflection_m(static_cast<double>(i) * dt_s, highpass_corner_Hz);
  }
  // An acceleration sample of 1 at τ adds (t − τ)Δt to each later w(t), and ω_c (t − τ)² Δt/2 with the high-pass
  // undone. The sample's weight is a sum over the later kernel values, so the sums run from the end.
  double once = 0, twice = 0, thrice = 0;
  for (std::size_t i = end; i-- > 0;) {
    out.by_noise[i] = (twice + kTwoPi * highpass_corner_Hz * thrice) * dt_s;
    once += kernel[i];
    twice += once * dt_s;
    thrice += twice * dt_s;
  }
  return out;
}

ParabolaResidual parabola_residual(std::span<const double> w, double from, double to) {
  const auto begin = static_cast<std::size_t>(from * static_cast<double>(w.size()));
  const auto end = static_cast<std::size_t>(to * static_cast<double>(w.size()));
  const auto count = static_cast<Eigen::Index>(end - begin);
  Eigen::Matrix3d normal;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto powers = [&](Eigen::Index i) {
    const double x = 2 * static_cast<double>(i) / static_cast<double>(count) - 1;
    return Eigen::Vector3d(1, x, x * x);
  };
  double sum_x = 0, sum_x2 = 0, sum_x3 = 0, sum_x4 = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d power = powers(i);
    sum_x += power(1);
    sum_x2 += power(2);
    sum_x3 += power(1) * power(2);
    sum_x4 += power(2) * power(2);
    right += power * w[begin + static_cast<std::size_t>(i)];
  }
  normal << static_cast<double>(count), sum_x, sum_x2, sum_x, sum_x2, sum_x3, sum_x2, sum_x3, sum_x4;
  const Eigen::Vector3d parabola = normal.inverse() * right;
  double energy = 0, last = 0;
  std::size_t crossings = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double value = w[begin + static_cast<std::size_t>(i)] - parabola.dot(powers(i));
    if (i > 0 && value * last < 0) ++crossings;
    last = value;
    energy += value * value;
  }
  return {.amplitude_m = std::sqrt(2 * energy / static_cast<double>(count)),
          .cycles = static_cast<double>(crossings) / 2};
}

double hann_leakage_m(double amplitude_m, double cycles) {
  return kLeakageMargin * amplitude_m * (1 / (std::numbers::pi * cycles * (cycles * cycles - 1)));
}

}  // namespace percuss::metrics
