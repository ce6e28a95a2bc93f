#include "identify/classify/tube_reading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percuss::identify {
namespace {

using std::numbers::pi;

constexpr std::size_t kTubePlanes = 45;  // 2° apart over 90°
constexpr double kPriors = 2.05;         // of bending, hoop and the others; RatioLikelihood::other() includes its own

// Logarithm of the likelihood over that of any ratio, for one plane and one placement of the sensors.
double log_factor(const std::vector<RatioAngle>& ratios, const RatioLikelihood& likelihood, double plane_rad,
                  std::size_t placement) {
  double sum = 0;
  for (const RatioAngle& ratio : ratios) {
    const double tube =
        likelihood.bending(ratio, plane_rad) + likelihood.hoop(ratio, placement) + likelihood.other(ratio);
    sum += std::log(pi * tube / kPriors);
  }
  return sum;
}

}  // namespace

double log_tube_evidence(const std::vector<RatioAngle>& ratios, const RatioLikelihood& likelihood) {
  if (ratios.empty()) return 0;
  std::vector<double> logs;
  double weights = 0;
  for (std::size_t e = 0; e < RatioLikelihood::kPlacements; ++e) {
    weights += kTubePlanes * RatioLikelihood::weight_of(e);
    for (std::size_t p = 0; p < kTubePlanes; ++p) {
      const double plane_rad = pi / 2 * static_cast<double>(p) / kTubePlanes;
      logs.push_back(log_factor(ratios, likelihood, plane_rad, e) + std::log(RatioLikelihood::weight_of(e)));
    }
  }
  const double most = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double one : logs) sum += std::exp(one - most);
  return most + std::log(sum / weights);
}

}  // namespace percuss::identify
