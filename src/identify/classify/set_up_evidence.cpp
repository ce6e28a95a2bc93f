#include "identify/classify/set_up_evidence.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::identify {
namespace {

// |dχ'/dχ| for tan χ' = tan χ/factor.
double stretch(double chi_rad, double factor) {
  const double sine = std::sin(chi_rad) / factor, cosine = std::cos(chi_rad);
  return 1 / (std::abs(factor) * (sine * sine + cosine * cosine));
}

}  // namespace

RatioAngle divided_by(const RatioAngle& ratio, double factor) {
  return {.chi_rad = std::atan(std::tan(ratio.chi_rad) / factor),
          .std_rad = ratio.std_rad * stretch(ratio.chi_rad, factor),
          .out_of_phase = ratio.out_of_phase};
}

double log_fault_evidence(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood, double factor) {
  std::vector<TypeEvidence> corrected = modes;
  double log_stretch = 0;
  for (TypeEvidence& mode : corrected) {
    if (!mode.ratio) continue;
    log_stretch += std::log(stretch(mode.ratio->chi_rad, factor));
    mode.ratio = divided_by(*mode.ratio, factor);
  }
  const double log_factor = log_set_up_evidence(corrected, likelihood) - log_set_up_evidence(modes, likelihood);
  return log_factor + std::min(log_stretch, 0.0);
}

}  // namespace percuss::identify
