#include "identify/ratio_likelihood.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace percuss {
namespace {

using std::numbers::pi;

constexpr double kFloor_rad = 0.035;  // 2°: shapes mix, and barrels are not round
constexpr double kPlane_rad = 0.14;   // 8°: how far the planes of different bending modes differ
constexpr double kKnownPlane = 0.7;   // weight of "in a known plane", the rest "in any"
constexpr double kRare = 0.05;        // of neither bending nor n = 2 among the modes of a bat below a few kHz
constexpr int kTurns = 180;
constexpr std::array<double, 5> kNodes{-1.5, -0.75, 0, 0.75, 1.5};       // of the placement error, in deviations …
constexpr std::array<double, 5> kWeights{0.12, 0.23, 0.30, 0.23, 0.12};  // … and a Gaussian's weight there

}  // namespace

double wrapped_density(double difference_rad, double std_rad) {
  const double d = std::remainder(difference_rad, pi);
  const double near = std::exp(-0.5 * d * d / (std_rad * std_rad)) / (std_rad * std::sqrt(2 * pi));
  return std_rad > 1 ? 1 / pi : near + 1e-6 / pi;  // so broad a Gaussian is the whole circle; no density is ever zero
}

RatioLikelihood::RatioLikelihood(double first_rad, double second_rad, double angle_std_rad)
    : first_rad_(first_rad), second_rad_(second_rad), angle_std_rad_(angle_std_rad) {}

double RatioLikelihood::over_all_turns(const RatioAngle& ratio, int n) const {
  const double std = std::hypot(ratio.std_rad, kFloor_rad);
  double sum = 0, weight = 0;
  for (int t = 0; t < kTurns; ++t) {
    const double turn = pi * (t + 0.5) / kTurns * 2 / n;
    for (std::size_t e = 0; e < kNodes.size(); ++e) {
      const double a = std::cos(n * (first_rad_ - turn));
      const double b = std::cos(n * (second_rad_ + kNodes[e] * angle_std_rad_ - turn));
      // A shape whose nodes lie at both sensors is seldom seen at all: weigh by what the sensors see.
      const double w = kWeights[e] * (a * a + b * b);
      sum += w * wrapped_density(ratio.chi_rad - std::atan2(b, a), std);
      weight += w;
    }
  }
  return sum / weight;
}

double RatioLikelihood::bending(const RatioAngle& ratio, const std::vector<double>& known) const {
  const double any = over_all_turns(ratio, 1);
  if (known.empty()) return any;
  const double std = std::hypot(ratio.std_rad, kPlane_rad);
  double in_plane = 0;
  for (const double chi : known) {
    in_plane += 0.5 * (wrapped_density(ratio.chi_rad - chi, std) + wrapped_density(ratio.chi_rad - chi - pi / 2, std));
  }
  return kKnownPlane * in_plane / static_cast<double>(known.size()) + (1 - kKnownPlane) * any;
}

double RatioLikelihood::hoop(const RatioAngle& ratio) const { return over_all_turns(ratio, 2); }

double RatioLikelihood::other(const RatioAngle& ratio) const {
  const double equal = wrapped_density(ratio.chi_rad - pi / 4, std::hypot(ratio.std_rad, 0.1));
  return kRare * (0.5 * equal + 0.5 / pi);
}

}  // namespace percuss
