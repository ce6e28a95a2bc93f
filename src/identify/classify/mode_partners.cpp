#include "identify/classify/mode_partners.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::identify {
namespace {

std::optional<std::size_t> nearest_mode(const std::vector<TypeEvidence>& modes, std::size_t m,
                                        const ClassifyOptions& options) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (i == m || !near_enough_for_one_mode(modes[i].freq_Hz, modes[m].freq_Hz, options)) continue;
    const auto apart = [&](std::size_t j) { return std::abs(modes[j].freq_Hz - modes[m].freq_Hz); };
    if (!best || apart(i) < apart(*best)) best = i;
  }
  return best;
}

}  // namespace

bool near_enough_for_one_mode(double a_Hz, double b_Hz, const ClassifyOptions& options) {
  return std::abs(a_Hz - b_Hz) <= std::max(options.double_peak_Hz, kPairSpacing * std::min(a_Hz, b_Hz));
}

void find_partners(std::vector<TypeEvidence>& modes, const ClassifyOptions& options) {
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto partner = nearest_mode(modes, m, options);
    if (partner && nearest_mode(modes, *partner, options) == m) modes[m].partner = partner;
  }
}

}  // namespace percuss::identify
