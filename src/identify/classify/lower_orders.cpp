#include <algorithm>
#include <optional>

#include "identify/classify/classify.hpp"
#include "identify/classify/three_waves.hpp"

namespace percuss::identify {
namespace {

constexpr double kMinConfidence = 0.9;  // of a lower mode that is counted
// Limits of the ratio of successive bending frequencies. Above kFirstRatio, the two are the first and the second order;
// above kMaxRatio, the lower one is motion on the suspension. Uniform beams have 2.76, 1.96, 1.65, …; bats 3.1 to 3.8
// for the first two.
constexpr double kFirstRatio = 2.3;
constexpr double kMaxRatio = 4.5;

std::vector<double> frequencies_Hz(const std::vector<Mode>& modes, const std::vector<ModeClassification>& types,
                                   ModeType type, double min_confidence, const ClassifyOptions& options) {
  std::vector<double> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (types[m].type != type || types[m].confidence < min_confidence) continue;
    // The two planes of a mode are one order.
    const double freq_Hz = modes[m].pole.freq_Hz;
    if (out.empty() || freq_Hz - out.back() > std::max(options.double_peak_Hz, kPairSpacing * freq_Hz))
      out.push_back(freq_Hz);
  }
  return out;
}

int lower_bending(const std::vector<double>& below_Hz, const std::vector<double>& found_Hz) {
  // The two lowest frequencies of the band may belong to the first and the second order.
  if (found_Hz.size() > 1 && found_Hz[1] > kFirstRatio * found_Hz[0]) return 0;
  int count = 0;
  std::optional<double> above_Hz;
  if (!found_Hz.empty()) above_Hz = found_Hz[0];
  for (std::size_t i = below_Hz.size(); i-- > 0;) {
    if (above_Hz && below_Hz[i] * kMaxRatio < *above_Hz) break;  // motion on the suspension
    const bool first = above_Hz && *above_Hz > kFirstRatio * below_Hz[i];
    ++count;
    if (first) break;
    above_Hz = below_Hz[i];
  }
  return count;
}

}  // namespace

LowerOrders lower_orders(const std::vector<Mode>& below, const std::vector<ModeClassification>& below_types,
                         const std::vector<Mode>& found, const std::vector<ModeClassification>& types,
                         const ClassifyOptions& options) {
  const auto lower = [&](ModeType type) { return frequencies_Hz(below, below_types, type, kMinConfidence, options); };
  return {
      .bending = lower_bending(lower(ModeType::bending), frequencies_Hz(found, types, ModeType::bending, 0, options)),
      .hoop = static_cast<int>(lower(ModeType::hoop).size())};
}

LowerTubeModes lower_tube_modes(const std::vector<Mode>& below, const std::vector<ModeClassification>& below_types,
                                const LowerOrders& lower, const ClassifyOptions& options) {
  LowerTubeModes out;
  const auto of_type = [&](ModeType type) { return frequencies_Hz(below, below_types, type, kMinConfidence, options); };
  if (const std::vector<double> hoop_Hz = of_type(ModeType::hoop); !hoop_Hz.empty()) out.lowest_hoop_Hz = hoop_Hz[0];
  out.bending_Hz = of_type(ModeType::bending);
  const std::size_t counted = std::min(out.bending_Hz.size(), static_cast<std::size_t>(std::max(lower.bending, 0)));
  out.bending_Hz.erase(out.bending_Hz.begin(), out.bending_Hz.end() - static_cast<std::ptrdiff_t>(counted));
  return out;
}

}  // namespace percuss::identify
