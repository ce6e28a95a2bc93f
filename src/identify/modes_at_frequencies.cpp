#include "identify/modes_at_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/hits/mode_windows.hpp"
#include "identify/identify.hpp"
#include "identify/start/unmodelled_peaks.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kMaxResonances = 40;
constexpr double kPeakRange_dB = 65;    // below the largest line: lower peaks are not searched
constexpr double kAwayFromModes = 1.5;  // half-power bandwidths, or line spacings where these are larger
// On either side of a resonance: enough lines for residual terms and two modes, and enough of the band for a wide mode
// and its neighbours.
constexpr double kMinLines = 40, kPartOfFrequency = 0.01, kWidths = 7;

constexpr double kNearLines = 1.5;  // a peak is the line nearest to its mode, or its neighbour

bool describes(const Mode& mode, double freq_Hz, double df_Hz) {
  return std::abs(mode.pole.freq_Hz - freq_Hz) <= std::max(mode.pole.half_power_Hz(), kNearLines * df_Hz);
}

bool is_among(const std::vector<Mode>& modes, const Mode& mode, double df_Hz) {
  return std::any_of(modes.begin(), modes.end(), [&](const Mode& other) {
    const double width_Hz = std::max({mode.pole.half_power_Hz(), other.pole.half_power_Hz(), df_Hz});
    return std::abs(mode.pole.freq_Hz - other.pole.freq_Hz) <= width_Hz;
  });
}

// The bandwidth of the stable pole at a frequency; 0 without one.
double half_power_at(const std::vector<Pole>& poles, double freq_Hz, double df_Hz) {
  double width_Hz = 0, least_Hz = std::numeric_limits<double>::infinity();
  for (const Pole& pole : poles) {
    const double apart_Hz = std::abs(pole.freq_Hz - freq_Hz);
    if (apart_Hz >= least_Hz || apart_Hz > std::max(pole.half_power_Hz(), kNearLines * df_Hz)) continue;
    least_Hz = apart_Hz;
    width_Hz = pole.half_power_Hz();
  }
  return width_Hz;
}

}  // namespace

std::vector<UnmodelledResonance> unmodelled_resonances(const FrfDataset& set, const std::vector<Mode>& modes,
                                                       const std::vector<Pole>& poles) {
  std::vector<UnmodelledPeak> peaks = unmodelled_peaks(set, modes, kPeakRange_dB);
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.level_dB > b.level_dB; });
  std::vector<UnmodelledResonance> out;
  out.reserve(peaks.size());
  for (const UnmodelledPeak& peak : peaks)
    out.push_back({peak.freq_Hz, half_power_at(poles, peak.freq_Hz, set.lines.df_Hz())});
  for (const Pole& pole : poles) {
    const bool away = std::all_of(modes.begin(), modes.end(), [&](const Mode& mode) {
      const double width_Hz = std::max(mode.pole.half_power_Hz(), set.lines.df_Hz());
      return std::abs(mode.pole.freq_Hz - pole.freq_Hz) > kAwayFromModes * width_Hz;
    });
    if (away) out.push_back({pole.freq_Hz, pole.half_power_Hz()});
  }
  return out;
}

std::vector<Mode> modes_at_frequencies(const FrfDataset& set, const std::vector<Mode>& modes,
                                       const std::vector<UnmodelledResonance>& resonances, Effort effort) {
  const double df_Hz = set.lines.df_Hz();
  std::vector<Mode> added;
  for (std::size_t r = 0; r < std::min(resonances.size(), kMaxResonances); ++r) {
    const double at_Hz = resonances[r].freq_Hz;
    const auto is_there = [&](const Mode& mode) { return describes(mode, at_Hz, df_Hz); };
    if (std::any_of(added.begin(), added.end(), is_there)) continue;
    const double reach_Hz = std::max(kPartOfFrequency * at_Hz, kWidths * resonances[r].half_power_Hz);
    const ModeWindow window = window_around(set, modes, at_Hz, std::max(kMinLines, reach_Hz / df_Hz));
    for (Mode& mode : identify_modes(frfs_within(set, modes, window), {.effort = effort})) {
      if (is_there(mode) && !is_among(modes, mode, df_Hz) && !is_among(added, mode, df_Hz))
        added.push_back(std::move(mode));
    }
  }
  std::sort(added.begin(), added.end(), [](const Mode& a, const Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  return added;
}

}  // namespace percuss::identify
