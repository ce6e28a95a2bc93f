#include "pipeline/stages/cancelled_tones.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "identify/fit/joint_fit.hpp"
#include "identify/hits/mode_windows.hpp"
#include "identify/hits/residue_coherence.hpp"
#include "identify/identify.hpp"
#include "identify/model/frf_lines.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr std::size_t kMinHits = 3;
constexpr double kReach = 0.1, kMinLines = 40;  // half-width of the fitted lines: of the tone's frequency; at least
constexpr double kMarginWidths = 5;             // half-power bandwidths of the fitted lines on each side of a mode
constexpr double kMinMarginWidths = 1;          // … on each side of a mode whose fitted values count
constexpr double kToneOff = 0.01;               // relative error of the frequency of a tone that wanders
constexpr std::size_t kToneLines = 3;           // on either side of its peak
constexpr double kDominates = 30;               // power of the tone over all else in these lines
constexpr double kBetter = 0.7;                 // standard deviation of a better value, relative
constexpr double kTonePart = 0.3;               // of the power at a line: if more is unexplained, it is a tone
constexpr double kMatch = 3;                    // standard deviations between two values of one mode

// The combinations of the channels in which a tone cancels, a column for each.
using Combinations = MatrixXcd;

// The part of the responses that the force does not explain, at one line: the response minus the average FRF times the
// force. Its power matrix [channels, channels], summed over the hits.
MatrixXcd unexplained_power(const identify::FrfDataset& set, const identify::HitFrfs& hits, std::size_t line) {
  const std::size_t channels = set.channels.size();
  MatrixXcd power = MatrixXcd::Zero(static_cast<Index>(channels), static_cast<Index>(channels));
  for (std::size_t h = 0; h < hits.set.points.size(); ++h) {
    const Complex force = hits.set.points[h].spectra.front().get()[line];
    Eigen::VectorXcd left(static_cast<Index>(channels));
    for (std::size_t c = 0; c < channels; ++c)
      left(static_cast<Index>(c)) = hits.accel[h * channels + c][line] - set.channels[c].frf[line] * force;
    power += left * left.adjoint();
  }
  return power;
}

// The combinations in which this tone cancels. Nothing where the tone does not dominate the lines at its peak.
std::optional<Combinations> combinations_without(const Tone& tone, const identify::FrfDataset& set,
                                                 const identify::HitFrfs& hits) {
  const acquire::LineRange& lines = set.lines;
  const double off = std::max(1.0, kToneOff * tone.freq_Hz / lines.df_Hz());
  const std::size_t low = lines.at(lines.position(tone.freq_Hz) - off),
                    high = lines.at(lines.position(tone.freq_Hz) + off);
  std::size_t peak = low;
  double largest = 0;
  for (std::size_t line = low; line <= high; ++line) {
    const double power = unexplained_power(set, hits, line).trace().real();
    if (power > largest) std::tie(peak, largest) = std::pair(line, power);
  }
  MatrixXcd power = unexplained_power(set, hits, peak);
  for (std::size_t i = 1; i <= kToneLines; ++i) {
    if (peak >= i) power += unexplained_power(set, hits, peak - i);
    if (peak + i < lines.count) power += unexplained_power(set, hits, peak + i);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(power);  // values ascend
  const Index rest = power.rows() - 1;
  if (!(eigen.eigenvalues()(rest) > kDominates * eigen.eigenvalues().head(rest).sum())) return std::nullopt;
  return eigen.eigenvectors().leftCols(rest);
}

// The lines around a tone, and the modes within them. The lines extend beyond a mode near their end, so that it is
// fitted with lines on both sides.
identify::ModeWindow window_around(const Tone& tone, const identify::FrfDataset& set,
                                   const std::vector<identify::Mode>& modes) {
  const double least_Hz = std::max(kMinLines * set.lines.df_Hz(), kReach * tone.freq_Hz);
  double reach_Hz = least_Hz;
  for (const identify::Mode& mode : modes) {
    const double apart_Hz = std::abs(mode.pole.freq_Hz - tone.freq_Hz);
    const double margin_Hz = kMarginWidths * mode.pole.half_power_Hz();
    if (apart_Hz < least_Hz + margin_Hz) reach_Hz = std::max(reach_Hz, apart_Hz + margin_Hz);
  }
  return identify::window_around(set, modes, tone.freq_Hz, reach_Hz / set.lines.df_Hz());
}

bool is_well_inside(const identify::Mode& mode, const acquire::LineRange& lines) {
  const double margin_Hz = kMinMarginWidths * mode.pole.half_power_Hz();
  return mode.pole.freq_Hz - margin_Hz > lines.freq_Hz(0) &&
         mode.pole.freq_Hz + margin_Hz < lines.freq_Hz(lines.count - 1);
}

// The average and the hits of a window in some combinations of the channels.
struct CombinedFrfs {
  identify::FrfDataset set;
  std::vector<std::vector<Complex>> spectra;
  identify::HitFrfs hits;  // refers to spectra
};

CombinedFrfs combined(const identify::FrfDataset& set, const identify::HitFrfs& hits,
                      const std::vector<identify::Mode>& modes, const identify::ModeWindow& window,
                      const Combinations& combinations) {
  const std::vector<Eigen::VectorXcd> data = identify::window_data(set, modes, window);
  const auto count = static_cast<Index>(window.count);
  CombinedFrfs out{
      .set = identify::lines_of(set, window.first, window.count),
      .spectra = {},
      .hits = {.set = identify::lines_of(hits.set, window.first, window.count), .accel = {}, .points = hits.points}};
  out.set.channels.clear();
  out.hits.set.channels.clear();
  for (Index j = 0; j < combinations.cols(); ++j) {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(count);
    for (std::size_t c = 0; c < data.size(); ++c) sum += std::conj(combinations(static_cast<Index>(c), j)) * data[c];
    out.set.channels.push_back({.point = 0, .channel = static_cast<std::size_t>(j), .frf = {sum.begin(), sum.end()}});
  }
  for (std::size_t first = 0; first + data.size() <= hits.accel.size(); first += data.size()) {
    for (Index j = 0; j < combinations.cols(); ++j) {
      std::vector<Complex>& sum = out.spectra.emplace_back(window.count);
      for (std::size_t c = 0; c < data.size(); ++c) {
        const Complex weight = std::conj(combinations(static_cast<Index>(c), j));
        for (std::size_t k = 0; k < window.count; ++k) sum[k] += weight * hits.accel[first + c][window.first + k];
      }
      out.hits.set.channels.push_back(
          {.point = first / data.size(), .channel = static_cast<std::size_t>(j), .frf = {}});
    }
  }
  out.hits.accel.assign(out.spectra.begin(), out.spectra.end());
  return out;
}

// The modes of the combinations that follow the force, and whose two flanks lie within the lines.
std::vector<identify::Mode> modes_of(const CombinedFrfs& frfs, identify::Effort effort) {
  const std::vector<identify::Mode> found = identify::identify_modes(frfs.set, {.effort = effort});
  const std::vector<std::optional<bool>> agree = identify::residues_agree_between_hits(frfs.set, frfs.hits, found);
  std::vector<identify::Mode> out;
  for (std::size_t m = 0; m < found.size(); ++m)
    if (agree[m].value_or(false) && is_well_inside(found[m], frfs.set.lines)) out.push_back(found[m]);
  return out;
}

// Pairs of found modes and `modes` of the window that are one mode, the nearest first: [found] index of the mode.
std::vector<std::optional<std::size_t>> matches(const std::vector<identify::Mode>& found,
                                                const std::vector<identify::Mode>& modes,
                                                const identify::ModeWindow& window) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t f = 0; f < found.size(); ++f) {
    for (const std::size_t m : window.modes) {
      const double apart_Hz = std::abs(found[f].pole.freq_Hz - modes[m].pole.freq_Hz);
      const double std_Hz = std::hypot(found[f].freq_std_Hz, modes[m].freq_std_Hz);
      if (apart_Hz <= std::max(modes[m].pole.half_power_Hz(), kMatch * std_Hz)) pairs.emplace_back(apart_Hz, f, m);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::optional<std::size_t>> match(found.size());
  for (const auto& [apart_Hz, f, m] : pairs) {
    if (!match[f] && std::find(match.begin(), match.end(), m) == match.end()) match[f] = m;
  }
  return match;
}

// Gives the modes at `changed` the residues that fit all channels over the window.
void fit_residues_of(const std::vector<std::size_t>& changed, std::vector<identify::Mode>& modes,
                     const identify::FrfDataset& set, const identify::ModeWindow& window) {
  const identify::FrfDataset part = identify::frfs_within(set, modes, window);
  Eigen::VectorXd variance(static_cast<Index>(2 * window.modes.size()));
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    variance(static_cast<Index>(2 * i)) = std::pow(modes[window.modes[i]].freq_std_Hz, 2);
    variance(static_cast<Index>(2 * i + 1)) = std::pow(modes[window.modes[i]].damping_std, 2);
  }
  const identify::JointFit fit = identify::fit_residues(part, window.poles(modes), variance.asDiagonal());
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    const std::size_t m = window.modes[i];
    if (std::find(changed.begin(), changed.end(), m) == changed.end()) continue;
    modes[m].residues.clear();
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      const auto channel = static_cast<Index>(o), column = static_cast<Index>(i);
      modes[m].residues.push_back(
          {.point = set.channels[o].point,
           .channel = set.channels[o].channel,
           .value = fit.residues(channel, column),
           .std = fit.residue_std(channel, column),
           .relative_std = identify::gain_amplitude_std(set, set.channels[o].point, modes[m].pole.freq_Hz)});
    }
  }
}

void refit_near(const Tone& tone, std::vector<identify::Mode>& modes, const identify::FrfDataset& set,
                const identify::HitFrfs& hits, identify::Effort effort) {
  const std::optional<Combinations> combinations = combinations_without(tone, set, hits);
  if (!combinations) return;
  const identify::ModeWindow window = window_around(tone, set, modes);
  const std::vector<identify::Mode> found = modes_of(combined(set, hits, modes, window, *combinations), effort);
  const auto match = matches(found, modes, window);
  std::vector<double> changed_Hz;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (match[f] && found[f].freq_std_Hz >= kBetter * modes[*match[f]].freq_std_Hz) continue;
    changed_Hz.push_back(found[f].pole.freq_Hz);
    if (match[f]) {
      modes[*match[f]] = found[f];
    } else {
      modes.push_back(found[f]);
    }
  }
  if (changed_Hz.empty()) return;
  // The residues of the combinations are replaced before anything reads them.
  for (identify::Mode& mode : modes) mode.residues.resize(set.channels.size());
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  std::vector<std::size_t> changed;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (std::find(changed_Hz.begin(), changed_Hz.end(), modes[m].pole.freq_Hz) != changed_Hz.end())
      changed.push_back(m);
  }
  fit_residues_of(changed, modes, set, window_around(tone, set, modes));
}

}  // namespace

std::vector<Tone> tones_at(const std::vector<double>& freq_Hz, const identify::FrfDataset& set,
                           const identify::HitFrfs& hits) {
  std::vector<Tone> tones;
  if (!can_cancel_tones(set, hits)) return tones;
  for (const double at_Hz : freq_Hz) {
    const std::size_t line = set.lines.nearest(at_Hz);
    double power = 0;
    for (const auto& spectrum : hits.accel) power += std::norm(spectrum[line]);
    if (unexplained_power(set, hits, line).trace().real() > kTonePart * power)
      tones.push_back({.freq_Hz = at_Hz, .wanders = true});
  }
  return tones;
}

bool can_cancel_tones(const identify::FrfDataset& set, const identify::HitFrfs& hits) {
  return set.points.size() == 1 && set.channels.size() > 1 && hits.points.size() >= kMinHits;
}

void refit_modes_near_tones(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                            const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort) {
  if (!can_cancel_tones(set, hits)) return;
  for (const Tone& tone : tones) {
    const bool within = tone.freq_Hz > set.lines.freq_Hz(0) && tone.freq_Hz < set.lines.freq_Hz(set.lines.count - 1);
    if (tone.wanders && within) refit_near(tone, modes, set, hits, effort);
  }
}

}  // namespace percuss::pipeline
