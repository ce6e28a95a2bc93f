#include "report/coherence_summary.hpp"

namespace percuss {

namespace {
constexpr double kGood = 0.9;
}

std::optional<CoherenceSummary> summary_of_coherence(const Analysis& analysis, const PointFrf& frf) {
  const auto [low, high] = analysis.band_Hz();
  const auto& coherence = frf.frf.coherence;
  double sum = 0, lines = 0, below = 0;
  for (std::size_t k = 0; k < coherence.size(); ++k) {
    const double freq_Hz = analysis.lines().freq_Hz(k);
    if (freq_Hz < low || freq_Hz > high) continue;
    ++lines;
    sum += coherence[k];
    if (coherence[k] < kGood) ++below;
  }
  if (lines == 0) return std::nullopt;
  return CoherenceSummary{.mean = sum / lines, .below = below / lines};
}

}  // namespace percuss
