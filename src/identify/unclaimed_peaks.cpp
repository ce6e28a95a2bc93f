#include "identify/unclaimed_peaks.hpp"

#include <algorithm>
#include <cmath>

#include "identify/candidates.hpp"
#include "identify/line_noise.hpp"

namespace percuss {
namespace {

constexpr double kNear = 3;  // half-power bandwidths, and lines

}  // namespace

std::vector<UnclaimedPeak> unclaimed_peaks(const FrfSet& set, const std::vector<Mode>& modes, double range_dB) {
  double largest = 0;
  for (std::size_t k = 0; k < set.lines.count; ++k) largest = std::max(largest, power_at(set, k));
  std::vector<UnclaimedPeak> peaks;
  for (const std::size_t line : prominent_lines(set, LineNoise(set))) {
    const double freq_Hz = set.lines.freq_Hz(line);
    const bool claimed = std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) {
      const double reach_Hz = kNear * std::max(mode.pole.half_power_Hz(), set.lines.df_Hz());
      return std::abs(mode.pole.freq_Hz - freq_Hz) <= reach_Hz;
    });
    const double level_dB = 10 * std::log10(power_at(set, line) / largest);
    const bool reached = set.reach_Hz <= 0 || freq_Hz <= set.reach_Hz;
    if (!claimed && reached && level_dB >= -range_dB) peaks.push_back({.freq_Hz = freq_Hz, .level_dB = level_dB});
  }
  return peaks;
}

}  // namespace percuss
