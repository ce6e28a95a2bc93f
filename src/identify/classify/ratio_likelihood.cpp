#include "identify/classify/ratio_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percuss::identify {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kPatternStd_rad = 0.035;  // 2°: error of the pattern, for mixed shapes and barrels that are not round
constexpr double kPlaneStd_rad = 0.14;     // 8°: scatter of the planes of different bending modes
// Prior of bending in the bat's plane or at right angles to it; the rest is bending in any plane.
constexpr double kKnownPlane = 0.7;
constexpr double kBlowStd_rad = 0.02;  // 1°: scatter of the bending planes of a round tube about the plane of the blow
constexpr double kPlaneOfBlow = 0.9;   // prior of this plane; the rest is bending in any plane
// Prior of modes that are neither bending nor n = 2, for a bat below a few kHz.
constexpr double kOtherTypePrior = 0.05;
constexpr double kMinDensity = 1e-6;  // lower limit of a density
// Quadrature point of the angle error, in standard deviations, and its Gaussian weight.
constexpr std::array<double, RatioLikelihood::kPlacements> kNodes{-2.4, -1.6, -0.8, 0, 0.8, 1.6, 2.4};
constexpr std::array<double, RatioLikelihood::kPlacements> kWeights{0.018, 0.089, 0.232, 0.322, 0.232, 0.089, 0.018};

// μ of (1) for a pattern of n waves: α = (e^−jp + j e^−jq)/2, β = (e^jp + j e^jq)/2 with p, q = n times the angles.
Complex mean_of(int n, double first_rad, double second_rad) {
  const Complex p = std::polar(1.0, n * first_rad), q = std::polar(1.0, n * second_rad), j(0, 1);
  const Complex alpha = std::conj(p) + j * std::conj(q), beta = p + j * q;
  return std::norm(beta) <= std::norm(alpha) ? beta / std::conj(alpha) : alpha / std::conj(beta);
}

}  // namespace

double wrapped_density(double difference_rad, double std_rad) {
  const double d = std::remainder(difference_rad, pi);
  const double near = std::exp(-0.5 * d * d / (std_rad * std_rad)) / (std_rad * std::sqrt(2 * pi));
  return std_rad > 1 ? 1 / pi : near + kMinDensity / pi;  // so broad a Gaussian is uniform
}

double RatioLikelihood::weight_of(std::size_t placement) { return kWeights[placement]; }

RatioLikelihood::RatioLikelihood(double first_rad, double second_rad, const SetUpError& error)
    : first_rad_(first_rad),
      second_rad_(second_rad),
      apart_std_rad_(std::numbers::sqrt2 * error.angle_rad),
      gain_std_(std::numbers::sqrt2 * error.gain),
      bending_mean_(mean_of(1, first_rad, second_rad)) {
  for (std::size_t e = 0; e < kPlacements; ++e)
    hoop_mean_[e] = mean_of(2, first_rad, second_rad + kNodes[e] * apart_std_rad_);
}

// A relative gain error e changes χ by e sin χ cos χ.
double RatioLikelihood::chi_std_rad(const RatioAngle& ratio) const {
  return std::hypot(ratio.std_rad, kPatternStd_rad, 0.5 * std::sin(2 * ratio.chi_rad) * gain_std_);
}

double RatioLikelihood::density(const RatioAngle& ratio, Complex mean) const {  // (1)
  const double s = chi_std_rad(ratio);
  const Complex z = std::polar(1.0, 2 * ratio.chi_rad) * std::conj(mean);
  // factor = e^(−2 k² s²): `step` is the ratio of successive factors, `shrink` the ratio of successive steps.
  const double shrink = std::exp(-4 * s * s);
  double factor = std::exp(-2 * s * s), step = factor * shrink, sum = 1;
  Complex power = z;
  while (factor * std::abs(power) > kMinDensity) {
    sum += 2 * factor * power.real();
    power *= z;
    factor *= step;
    step *= shrink;
  }
  return std::max(sum, kMinDensity) / pi;
}

double RatioLikelihood::bending(const RatioAngle& ratio) const { return density(ratio, bending_mean_); }

double RatioLikelihood::bending_in(const RatioAngle& ratio, double plane_rad, double plane_std_rad) const {
  const double a = std::cos(first_rad_ - plane_rad), b = std::cos(second_rad_ - plane_rad);
  const double slope = std::abs(std::sin(second_rad_ - first_rad_)) / std::max(a * a + b * b, kMinDensity);  // dχ/dψ
  return wrapped_density(ratio.chi_rad - std::atan2(b, a), std::hypot(chi_std_rad(ratio), slope * plane_std_rad));
}

double RatioLikelihood::bending(const RatioAngle& ratio, double plane_rad) const {
  double in_plane = 0;
  for (const double plane : {plane_rad, plane_rad + pi / 2}) in_plane += 0.5 * bending_in(ratio, plane, kPlaneStd_rad);
  return kKnownPlane * in_plane + (1 - kKnownPlane) * bending(ratio);
}

double RatioLikelihood::bending_of_blow(const RatioAngle& ratio, double plane_rad) const {
  return kPlaneOfBlow * bending_in(ratio, plane_rad, kBlowStd_rad) + (1 - kPlaneOfBlow) * bending(ratio);
}

double RatioLikelihood::hoop(const RatioAngle& ratio, std::size_t placement) const {
  return density(ratio, hoop_mean_[placement]);
}

double RatioLikelihood::hoop(const RatioAngle& ratio) const {
  double sum = 0;
  for (std::size_t e = 0; e < kPlacements; ++e) sum += kWeights[e] * hoop(ratio, e);
  return sum;
}

double RatioLikelihood::three_waves(const RatioAngle& ratio) const {
  double sum = 0;
  for (std::size_t e = 0; e < kPlacements; ++e)
    sum += kWeights[e] * density(ratio, mean_of(3, first_rad_, second_rad_ + kNodes[e] * apart_std_rad_));
  return sum;
}

double RatioLikelihood::other(const RatioAngle& ratio) const {
  const double equal = wrapped_density(ratio.chi_rad - pi / 4, std::hypot(ratio.std_rad, 0.1));
  return kOtherTypePrior * (0.5 * equal + 0.5 / pi);
}

// The ratio gives the pattern's angle, and so the amplitudes a and b at the two sensors:
// a² + b² = sin² nΔ/(1 − sin 2χ cos nΔ), Δ the angle between the sensors.
double RatioLikelihood::observed_amplitude(const RatioAngle& ratio, int n) const {
  const double apart = n * (second_rad_ - first_rad_), blur = n * apart_std_rad_;
  const double sine_2 = std::min(std::pow(std::sin(apart), 2) + blur * blur, 1.0);
  const double cosine = std::copysign(std::sqrt(1 - sine_2), std::cos(apart));
  return std::sqrt(sine_2 / std::max(1 - std::sin(2 * ratio.chi_rad) * cosine, sine_2 / 2));
}

}  // namespace percuss::identify
