#include "identify/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "core/statistics.hpp"
#include "identify/peaks.hpp"

namespace percuss {
namespace {

constexpr std::size_t kNoiseLines = 129;     // over which the noise is taken as even
constexpr double kMedianOfNoise = 0.693147;  // median of an exponential distribution: |complex Gaussian|²
constexpr double kRoughnessGain = 1.5;       // variance of x(k) − (x(k−1) + x(k+1))/2 over that of x
constexpr double kNoiseProminence = 6;       // deviations of the level's own fluctuation
constexpr double kDecibelsPerNeper = 8.6859;

struct Level {
  std::vector<double> power, noise;  // Σ over outputs of |H|² and of the noise's share
};

// Noise from roughness: where the FRF is smooth the second difference is noise alone; the median skips the resonances.
Level level_of(const FrfSet& set) {
  const std::size_t n = set.lines.count;
  Level level{std::vector<double>(n), std::vector<double>(n)};
  std::vector<double> rough(n);
  for (const Output& output : set.outputs) {
    for (std::size_t k = 0; k < n; ++k) level.power[k] += std::norm(output.frf[k]);
    for (std::size_t k = 1; k + 1 < n; ++k) {
      rough[k] += std::norm(output.frf[k] - 0.5 * (output.frf[k - 1] + output.frf[k + 1])) / kRoughnessGain;
    }
  }
  const std::size_t half = kNoiseLines / 2;
  for (std::size_t block = 0; block < n; block += half) {
    const std::size_t begin = std::max<std::size_t>(1, block > half ? block - half : 1);
    const std::size_t end = std::min(n - 1, block + 2 * half);
    const double noise = begin < end ? median({rough.begin() + static_cast<std::ptrdiff_t>(begin), rough.begin() + static_cast<std::ptrdiff_t>(end)}) : 0;
    for (std::size_t k = block; k < std::min(n, block + half); ++k) level.noise[k] = noise / kMedianOfNoise;
  }
  return level;
}

std::vector<Eigen::VectorXcd> cut(const FrfSet& set, std::size_t first, std::size_t count) {
  std::vector<Eigen::VectorXcd> out;
  for (const Output& output : set.outputs) {
    out.emplace_back(Eigen::Map<const Eigen::VectorXcd>(output.frf.data() + first, static_cast<Eigen::Index>(count)));
  }
  return out;
}

Pole pole_at_line(const FrfSet& set, std::size_t line) {
  // First a narrow window, then one as wide as the pole it found: the linear fit is best over a few bandwidths.
  Pole pole;
  std::size_t half = 4;
  for (int pass = 0; pass < 3; ++pass) {
    const std::size_t first = line > half ? line - half : 0;
    const std::size_t end = std::min(set.lines.count, line + half + 1);
    if (end - first < 4) break;
    const Pole found = pole_of_window(set, cut(set, first, end - first), first);
    const bool near = std::abs(found.freq_Hz - set.lines.freq_Hz(line)) < static_cast<double>(half) * set.lines.df_Hz();
    if (!(found.freq_Hz > 0) || !near) break;
    pole = found;
    half = static_cast<std::size_t>(std::clamp(2 * pole.half_power_Hz() / set.lines.df_Hz(), 4.0, 400.0));
  }
  if (pole.freq_Hz > 0) return pole;
  const double freq_Hz = std::max(set.lines.freq_Hz(line), set.lines.df_Hz());
  return {.freq_Hz = freq_Hz, .damping_ratio = std::min(0.1, set.lines.df_Hz() / freq_Hz)};
}

}  // namespace

std::vector<Pole> candidate_poles(const FrfSet& set, const CandidateOptions& options) {
  if (set.lines.count < 5) return {};
  const Level level = level_of(set);
  std::vector<double> level_dB(set.lines.count);
  for (std::size_t k = 0; k < level_dB.size(); ++k) level_dB[k] = 10 * std::log10(std::max(level.power[k], 1e-300));
  std::vector<Pole> poles;
  for (const Peak& peak : find_peaks(level_dB)) {
    if (peak.line == 0 || peak.line + 1 == level_dB.size()) continue;
    const double snr = level.noise[peak.line] > 0 ? std::sqrt(level.power[peak.line] / level.noise[peak.line]) : 1e9;
    const double wobble_dB = kNoiseProminence * kDecibelsPerNeper / (snr * std::sqrt(2.0));
    if (snr < options.snr || peak.prominence < options.prominence_dB + wobble_dB) continue;
    poles.push_back(pole_at_line(set, peak.line));
  }
  return poles;
}

Pole pole_near(const FrfSet& set, double freq_Hz) {
  const double at = freq_Hz / set.lines.df_Hz() - static_cast<double>(set.lines.first);
  auto line = static_cast<std::size_t>(std::clamp(std::round(at), 0.0, static_cast<double>(set.lines.count - 1)));
  Pole pole = pole_at_line(set, line);
  const double reach = std::max(4 * set.lines.df_Hz(), 2 * pole.half_power_Hz());
  if (std::abs(pole.freq_Hz - freq_Hz) > reach) pole.freq_Hz = freq_Hz;
  return pole;
}

}  // namespace percuss
