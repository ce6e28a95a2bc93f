#include "metrics/deflection/final_rest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/math/statistics.hpp"
#include "metrics/deflection/held_structure.hpp"
#include "metrics/deflection/window_mean.hpp"

namespace percuss::metrics {
namespace {

constexpr std::array kRestFrom{1.0 / 6, 1.0 / 3, 1.0 / 2, 2.0 / 3};  // candidates, as parts of the motion
// Noise of the rest after over the noise before: more than chance, whose few per cent come from the shorter rest, and
// less than a motion that matters. A swing raises the means over half its period far more than the samples.
constexpr double kSameNoise = 1.2;
constexpr std::size_t kMinFinalRest = 64;
constexpr double kIntegrationError = 1e-6;  // of the largest deflection: rounding of the double integral
constexpr double kNoRestPosition = 36;      // χ² of four observations, exceeded by chance once in four million

struct RestAfter {
  double from = 0;        // part of the motion
  std::size_t first = 0;  // sample
  BaselineEstimate line;
};

std::optional<RestAfter> rest_after(std::span<const double> accel_mps2, double fs_Hz, double noise_mps2) {
  for (const double from : kRestFrom) {
    const auto first = static_cast<std::size_t>(from * static_cast<double>(accel_mps2.size()));
    if (accel_mps2.size() - first < kMinFinalRest) return std::nullopt;
    BaselineEstimate line = baseline_estimate(accel_mps2.subspan(first), fs_Hz, 0);
    if (line.noise_mps2 <= kSameNoise * noise_mps2) return RestAfter{from, first, std::move(line)};
  }
  return std::nullopt;
}

}  // namespace

ZeroMeanCorrection final_rest_correction(std::span<const double> accel_mps2, std::span<const double> deflection_m,
                                         double fs_Hz, const BaselineEstimate& rest) {
  ZeroMeanCorrection none{.bias = Eigen::Vector2d::Zero(), .covariance = rest.covariance};
  const double noise = rest.residual_mps2.empty() ? 0 : rms(rest.residual_mps2);
  if (!(noise > 0) || rest.noise_mps2 > kSameNoise * noise) return none;
  const auto after = rest_after(accel_mps2, fs_Hz, noise);
  if (!after) return none;

  // value = by_line·(bias, drift) + by_noise·(samples of the noise)
  const auto samples = static_cast<Eigen::Index>(accel_mps2.size());
  const auto resting = static_cast<Eigen::Index>(accel_mps2.size() - after->first);
  Eigen::Vector4d value;
  Eigen::Matrix<double, 4, 2> by_line;
  Eigen::Matrix<double, 4, Eigen::Dynamic> by_noise = Eigen::Matrix<double, 4, Eigen::Dynamic>::Zero(4, samples);
  value.head<2>() = after->line.bias;  // the level after the last sample, and the slope
  by_line.topRows<2>() << 1, static_cast<double>(samples) / fs_Hz, 0, 1;
  const Eigen::Matrix2d inverse = after->line.covariance / (after->line.noise_mps2 * after->line.noise_mps2);
  for (Eigen::Index i = 0; i < resting; ++i) {
    const Eigen::Vector2d basis(1, static_cast<double>(i - resting) / fs_Hz);
    by_noise.col(samples - resting + i).head<2>() = inverse * basis;
  }
  const double middle = (1 + after->from) / 2;
  const std::array<std::pair<double, double>, 2> windows{{{after->from, middle}, {middle, 1.0}}};
  Eigen::Index row = 2;
  for (const auto& [from, to] : windows) {
    const WindowMean mean = window_mean(deflection_m, fs_Hz, 0, from, to);
    value(row) = mean.mean_m;
    by_line.row(row) = mean.by_bias.transpose();
    by_noise.row(row) = Eigen::Map<const Eigen::RowVectorXd>(mean.by_noise.data(), samples);
    ++row;
  }
  Eigen::Matrix4d covariance = rest.noise_mps2 * rest.noise_mps2 * by_noise * by_noise.transpose();
  const double error_m = kIntegrationError * extremes_of(deflection_m).max_distance_from(0);
  covariance.diagonal().tail<2>().array() += error_m * error_m;
  return correction_by_zeros<4>(value, by_line, covariance, rest, kNoRestPosition);
}

}  // namespace percuss::metrics
