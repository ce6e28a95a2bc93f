#include "identify/start/unmodelled_peaks.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/residual_smoothness.hpp"
#include "identify/start/stable_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kNear = 3;            // half-power bandwidths around a mode, or spectral lines where these are wider
constexpr double kUnexplained = 0.25;  // residual energy over a peak's energy: below it the modes explain the peak
constexpr double kPeakSpan = 6;        // half-widths on either side, for a peak's energy

// Energy of the lines around a resonance, a straight background removed.
template <class Lines>
double energy_around(const Resonance& at, const Lines& lines) {
  const double reach = kPeakSpan * at.half_width;
  const auto first = static_cast<Index>(std::max(0.0, std::floor(at.line - reach)));
  const auto last = std::min(lines.size() - 1, static_cast<Index>(std::ceil(at.line + reach)));
  const Eigen::VectorXcd part = lines.segment(first, last - first + 1);
  const Eigen::MatrixXd straight = orthonormal_polynomials(part.size(), 2);
  return (part - straight * (straight.transpose() * part)).squaredNorm();
}

// True where enough of the peak's energy remains in the residual. The peak is then not noise on a mode's flank or a
// truncation ripple.
bool unexplained(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& left, const Resonance& at) {
  double all = 0, rest = 0;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const Eigen::Map<const Eigen::VectorXcd> frf(set.channels[o].frf.data(), left[o].size());
    all += energy_around(at, frf);
    rest += energy_around(at, left[o]);
  }
  return rest > kUnexplained * all;
}

}  // namespace

std::vector<UnmodelledPeak> unmodelled_peaks(const FrfDataset& set, const std::vector<Mode>& modes, double range_dB) {
  std::vector<std::size_t> lines = prominent_lines(set, LineNoise(set));
  std::erase_if(lines, [&](std::size_t line) {
    const double freq_Hz = set.lines.freq_Hz(line);
    const bool reached = set.usable_bandwidth_Hz <= 0 || freq_Hz <= set.usable_bandwidth_Hz;
    return !reached || std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) {
      const double excluded_Hz = kNear * std::max(mode.pole.half_power_Hz(), set.lines.df_Hz());
      return std::abs(mode.pole.freq_Hz - freq_Hz) <= excluded_Hz;
    });
  });
  if (lines.empty()) return {};
  double largest = 0;
  for (std::size_t k = 0; k < set.lines.count; ++k) largest = std::max(largest, power_at(set, k));
  const auto left = residuals_from_sums(set, modal_sums(set, modes));
  const auto resonances = residual_resonances(set, left);
  std::vector<UnmodelledPeak> peaks;
  for (const std::size_t line : lines) {
    const bool remains = std::any_of(resonances.begin(), resonances.end(), [&](const Resonance& at) {
      return std::abs(at.line - static_cast<double>(line)) <= 2 * at.half_width && unexplained(set, left, at);
    });
    const double level_dB = 10 * std::log10(power_at(set, line) / largest);
    if (remains && level_dB >= -range_dB) peaks.push_back({.freq_Hz = set.lines.freq_Hz(line), .level_dB = level_dB});
  }
  return peaks;
}

std::vector<Pole> unmodelled_poles(const FrfDataset& set, const std::vector<Mode>& modes) {
  return unmodelled_poles(set, modes, modal_sums(set, modes));
}

std::vector<Pole> unmodelled_poles(const FrfDataset& set, const std::vector<Mode>& modes,
                                   const std::vector<Eigen::VectorXcd>& sums) {
  if (set.lines.count < 8 || set.channels.empty()) return {};
  const auto left = residuals_from_sums(set, sums);
  if (!smooth_somewhere(left)) return {};
  auto resonances = residual_resonances(set, left);
  std::erase_if(resonances, [&](const Resonance& at) { return !unexplained(set, left, at); });
  if (resonances.empty()) return {};
  std::vector<Pole> poles = stable_poles(set);
  std::erase_if(poles, [&](const Pole& pole) {
    const bool reached = set.usable_bandwidth_Hz <= 0 || pole.freq_Hz <= set.usable_bandwidth_Hz;
    const double line = set.lines.position(pole.freq_Hz);
    const bool remains = std::any_of(resonances.begin(), resonances.end(), [&](const Resonance& at) {
      return std::abs(at.line - line) <= 2 * at.half_width;
    });
    return !reached || !remains || std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) {
      return std::abs(mode.pole.freq_Hz - pole.freq_Hz) <= std::max(mode.pole.half_power_Hz(), set.lines.df_Hz());
    });
  });
  return poles;
}

}  // namespace percuss::identify
