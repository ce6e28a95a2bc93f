#include "identify/start/unmodelled_peaks.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/linear_algebra.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/peaks.hpp"
#include "identify/start/residual_smoothness.hpp"
#include "identify/start/stable_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kNear = 3;            // half-power bandwidths around a mode, or spectral lines where these are wider
constexpr double kUnexplained = 0.25;  // residual energy over a peak's energy: below it the modes explain the peak
constexpr double kClearOfNoise = 6;    // standard deviations of the difference of two lines
constexpr double kPeakSpan = 6;        // half-widths on either side, for a peak's energy

// The test for a tail compares the residual's energy after a straight line and after a polynomial of kTailTerms is
// subtracted, both without the noise's energy. The polynomial leaves at least 0.2 of a resonance within kPeakSpan whose
// width is known to a factor of 1.4 and whose place is known to its half-width. It leaves less than 0.15 for the tail
// of a mode that is farther away than 1.1 of that span. A polynomial of kNoiseTerms leaves only noise.
constexpr Index kTailTerms = 5, kNoiseTerms = 10;
constexpr double kTailRest = 0.15;

// The existing lines around a resonance.
struct Surroundings {
  Index first = 0, count = 0;
  bool complete = true;  // false where the spectral lines end within them
};

Surroundings surroundings_of(const Resonance& at, Index lines) {
  const double reach = kPeakSpan * at.half_width;
  const auto first = static_cast<Index>(std::floor(at.line - reach));
  const auto last = static_cast<Index>(std::ceil(at.line + reach));
  const Index from = std::max(first, Index{0}), to = std::min(last, lines - 1);
  return {.first = from, .count = to - from + 1, .complete = from == first && to == last};
}

// Energy of the lines around a resonance that the columns of `background` do not describe.
template <class Lines>
double energy_beside(const Eigen::MatrixXd& background, const Surroundings& around, const Lines& lines) {
  const Eigen::VectorXcd part = lines.segment(around.first, around.count);
  return (part - background * (background.transpose() * part)).squaredNorm();
}

template <class Lines>
double energy_around(const Resonance& at, const Lines& lines) {
  const Surroundings around = surroundings_of(at, lines.size());
  return energy_beside(orthonormal_polynomials(around.count, 2), around, lines);
}

// True where the residual around a resonance is the tail of a mode beyond the spectral lines: a polynomial describes
// it, or it is largest at the first or the last of all lines.
bool is_tail(const std::vector<Eigen::VectorXcd>& left, const Resonance& at) {
  const Index lines = left.front().size();
  const Surroundings around = surroundings_of(at, lines);
  if (!around.complete) {
    Eigen::VectorXd power = Eigen::VectorXd::Zero(around.count);
    for (const Eigen::VectorXcd& of_frf : left) power += of_frf.segment(around.first, around.count).cwiseAbs2();
    Index largest = 0;
    power.maxCoeff(&largest);
    return around.first + largest == 0 || around.first + largest + 1 == lines;
  }
  const auto energy_beside_polynomial = [&](Index terms) {
    const Eigen::MatrixXd background = orthonormal_polynomials(around.count, terms);
    double energy = 0;
    for (const Eigen::VectorXcd& of_frf : left) energy += energy_beside(background, around, of_frf);
    return energy;
  };
  const double noise_per_line =
      energy_beside_polynomial(kNoiseTerms) / static_cast<double>(std::max(around.count - kNoiseTerms, Index{1}));
  const auto beside_noise = [&](Index terms) {
    return energy_beside_polynomial(terms) - noise_per_line * static_cast<double>(around.count - terms);
  };
  return beside_noise(kTailTerms) < kTailRest * beside_noise(2);
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

std::vector<UnmodelledPeak> unmodelled_peaks(const FrfDataset& set, const std::vector<Mode>& modes, double range_dB,
                                             const std::vector<Mode>& beyond) {
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
  std::vector<Mode> all = modes;
  all.insert(all.end(), beyond.begin(), beyond.end());
  const auto left = residuals_from_sums(set, modal_sums(set, all));
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

std::vector<UnmodelledPeak> clear_of_noise(const FrfDataset& set, std::vector<UnmodelledPeak> peaks) {
  if (peaks.empty()) return peaks;
  const LineNoise line_noise(set);
  std::vector<std::vector<double>> local;  // [channels] noise power
  for (std::size_t o = 0; o < set.channels.size(); ++o) local.push_back(line_noise.local(o));
  std::vector<double> power(set.lines.count);
  for (std::size_t k = 0; k < power.size(); ++k) power[k] = power_at(set, k);
  std::map<std::size_t, double> saddle;  // by line
  for (const Peak& peak : find_peaks(power)) saddle[peak.line] = std::max(power[peak.line] - peak.prominence, 0.0);
  std::erase_if(peaks, [&](const UnmodelledPeak& peak) {
    const std::size_t line = set.lines.nearest(peak.freq_Hz);
    // The variance of √Σ|H|² at a line is Σ|H|²σ²/(2 Σ|H|²), with the noise power σ² of each FRF; for the difference of
    // two lines it is twice as large.
    double weighted = 0;
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const double noise_power = std::max(std::pow(line_noise.at(o, line), 2), local[o][line]);
      weighted += std::norm(set.channels[o].frf[line]) * noise_power;
    }
    const double std = power[line] > 0 ? std::sqrt(weighted / power[line]) : 0;
    return std::sqrt(power[line]) - std::sqrt(saddle[line]) < kClearOfNoise * std;
  });
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
  std::erase_if(resonances, [&](const Resonance& at) { return !unexplained(set, left, at) || is_tail(left, at); });
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
