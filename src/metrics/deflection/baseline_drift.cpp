#include "metrics/deflection/baseline_drift.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/significance.hpp"
#include "metrics/deflection/held_structure.hpp"
#include "metrics/deflection/window_mean.hpp"

namespace percuss::metrics {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr std::size_t kMinRest = 8;  // samples needed for a straight line and its scatter
// The standard deviation of an unknown bias, over the signal's RMS. A larger bias means a broken sensor.
constexpr double kUnknownBias = 0.1;
constexpr std::size_t kMinMeans = 8;
constexpr double kSteepest = 2;        // growth of the variance per octave, for noise of a power spectrum 1/f
constexpr double kColoured = 3;        // normal deviate from which noise is not white
constexpr double kMinCycles = 3;       // of the oscillation within a window, for a mean near zero
constexpr double kContradiction = 30;  // χ² of two means, exceeded by chance once in three million

// The standard deviation of white noise whose means over many samples scatter as those of `residual`, from which a
// straight line was subtracted. The means of coloured noise scatter more than those of white noise with the same
// standard deviation of a sample.
double low_frequency_std(std::span<const double> residual) {
  double largest = 0, growth = 1;  // of the variance, from the means half as long
  for (std::size_t length = 1; length == 1 || residual.size() / length >= kMinMeans; length *= 2) {
    const std::size_t means = residual.size() / length;
    double sum = 0;
    for (std::size_t b = 0; b < means; ++b) {
      double mean = 0;
      for (const double value : residual.subspan(b * length, length)) mean += value / static_cast<double>(length);
      sum += mean * mean * static_cast<double>(length);
    }
    const auto degrees = static_cast<double>(means) - 2;
    const double variance = sum / degrees;
    const bool more = length > 1 && chi2_deviate(sum / largest, degrees) > kColoured;
    if (length == 1 || more) {
      growth = length == 1 ? 1 : std::clamp(variance / largest, 1.0, kSteepest);
      largest = std::max(largest, variance);
    } else {
      growth = 1;
    }
    if (!(largest > 0)) return 0;
  }
  // The longest means cover an eighth of the samples at rest. The bias is a mean over all of them, three octaves more.
  return std::sqrt(largest * std::pow(growth, 3));
}

}  // namespace

BaselineEstimate baseline_estimate(std::span<const double> before_mps2, double fs_Hz, double rms_mps2) {
  const auto n = static_cast<double>(before_mps2.size());
  const double wide = kUnknownBias * rms_mps2;
  BaselineEstimate rest{.bias = Vector2d::Zero(), .covariance = Vector2d(wide * wide, wide * wide).asDiagonal()};
  if (before_mps2.size() < kMinRest) return rest;
  Matrix2d normal = Matrix2d::Zero();
  Vector2d right = Vector2d::Zero();
  const auto basis = [&](std::size_t i) { return Vector2d(1, (static_cast<double>(i) - n) / fs_Hz); };
  for (std::size_t i = 0; i < before_mps2.size(); ++i) {
    normal += basis(i) * basis(i).transpose();
    right += basis(i) * before_mps2[i];
  }
  const Matrix2d inverse = normal.inverse();
  rest.bias = inverse * right;
  rest.residual_mps2.resize(before_mps2.size());
  for (std::size_t i = 0; i < before_mps2.size(); ++i) rest.residual_mps2[i] = before_mps2[i] - rest.bias.dot(basis(i));
  rest.noise_mps2 = low_frequency_std(rest.residual_mps2);
  rest.covariance = inverse * rest.noise_mps2 * rest.noise_mps2;
  return rest;
}

ZeroMeanCorrection zero_mean_correction(std::span<const double> deflection_m, double fs_Hz, double highpass_corner_Hz,
                                        const BaselineEstimate& rest) {
  std::array<WindowMean, 2> windows;
  Vector2d mean, leaks;
  Matrix2d by_bias;
  const std::array<std::pair<double, double>, 2> places{{{1.0 / 3, 2.0 / 3}, {2.0 / 3, 1.0}}};
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto [from, to] = places.at(i);
    const ParabolaResidual swing = parabola_residual(deflection_m, from, to);
    if (swing.cycles < kMinCycles) return {.bias = Vector2d::Zero(), .covariance = rest.covariance};
    windows.at(i) = window_mean(deflection_m, fs_Hz, highpass_corner_Hz, from, to);
    const auto k = static_cast<Eigen::Index>(i);
    mean(k) = windows.at(i).mean_m;
    by_bias.row(k) = windows.at(i).by_bias.transpose();
    leaks(k) = hann_leakage_m(swing.amplitude_m, swing.cycles);
  }
  Matrix2d noise = leaks.cwiseAbs2().asDiagonal();
  for (Eigen::Index a = 0; a < 2; ++a) {
    for (Eigen::Index b = 0; b < 2; ++b) {
      const auto& x = windows.at(static_cast<std::size_t>(a)).by_noise;
      const auto& y = windows.at(static_cast<std::size_t>(b)).by_noise;
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
      noise(a, b) += sum * rest.noise_mps2 * rest.noise_mps2;
    }
  }
  return correction_by_zeros<2>(mean, by_bias, noise, rest, kContradiction);
}

}  // namespace percuss::metrics
