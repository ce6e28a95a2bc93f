#include "identify/hits/hit_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/math/random_effects.hpp"
#include "core/math/significance.hpp"
#include "identify/hits/hit_laws.hpp"
#include "identify/hits/moved_residues.hpp"
#include "identify/hits/nonlinearity_modes.hpp"
#include "identify/hits/shared_scatter.hpp"

namespace percuss::identify {
namespace {

// Standard deviations of trend_deviate(); without scatter, one pair of slopes in 2000 exceeds them.
constexpr double kSignificantTrend = 3.7;
constexpr std::size_t kMinHits = 2;
// Standard deviations of a residue in one hit. A hit with a clearer residue determines its pole, unless the pole
// changes during the hit or differs much from the mean.
constexpr double kClear = 20;

// A mode's frequency and damping ratio in the hits that determine its pole.
struct Known {
  std::vector<std::size_t> hits;
  std::vector<double> freq_Hz, freq_std_Hz, damping, damping_std;
};

Known known_of(const HitPoles& poles) {
  Known known;
  for (std::size_t h = 0; h < poles.hits.size(); ++h) {
    const HitPole& hit = poles.hits[h];
    if (!hit.known) continue;
    known.hits.push_back(h);
    known.freq_Hz.push_back(hit.pole.freq_Hz);
    known.freq_std_Hz.push_back(hit.freq_std_Hz);
    known.damping.push_back(hit.pole.damping_ratio);
    known.damping_std.push_back(hit.damping_std);
  }
  return known;
}

struct ModeScatter {
  Known known;
  ScatterOfHits freq, damping;
  bool freq_differs = false, damping_differs = false;
  bool points_differ = false;        // beyond the noise, and no point has several hits that would show the cause
  double freq_p = 1, damping_p = 1;  // p-values of the differences
  double damping_shift = 0, damping_shift_std = 0;  // by which take_mean() changed the mode
  bool significant() const { return freq_differs || damping_differs; }
  HitSeries series(std::size_t mode, bool is_freq) const {
    return {.mode = mode,
            .is_freq = is_freq,
            .hits = known.hits,
            .value = is_freq ? known.freq_Hz : known.damping,
            .std = is_freq ? known.freq_std_Hz : known.damping_std};
  }
};

// Whether hits of one point differ: χ² of the orthogonal contrasts of each point's hits, each hit against the mean of
// the hits before it. Nothing if no point has several hits. Values of different points may differ although no pole
// changes, because the residual moves the poles of the hits by a different amount at each point.
std::optional<bool> hits_of_a_point_differ(const HitSeries& series, const std::vector<std::size_t>& points) {
  struct Mean {
    double value = 0, variance = 0;
    std::size_t hits = 0;
  };
  std::map<std::size_t, Mean> means;
  double chi2 = 0, degrees = 0;
  for (std::size_t i = 0; i < series.hits.size(); ++i) {
    Mean& mean = means[points[series.hits[i]]];
    const double variance = series.std[i] * series.std[i], n = static_cast<double>(mean.hits);
    if (mean.hits > 0) {
      chi2 += std::pow(series.value[i] - mean.value, 2) / (variance + mean.variance);
      ++degrees;
    }
    mean.value += (series.value[i] - mean.value) / (n + 1);
    mean.variance = (mean.variance * n * n + variance) / ((n + 1) * (n + 1));
    ++mean.hits;
  }
  if (degrees == 0) return std::nullopt;
  return chi2_deviate(chi2, degrees) > kOnceIn1000;
}

// points  [hits] index of the hit's point
ModeScatter scatter_of_mode(const HitPoles& poles, const std::vector<double>& peak_N,
                            const std::vector<std::size_t>& points) {
  ModeScatter scatter{.known = known_of(poles), .freq = {}, .damping = {}};
  if (scatter.known.hits.size() < kMinHits) return scatter;
  const bool one_point = std::set<std::size_t>(points.begin(), points.end()).size() == 1;
  scatter.freq = scatter_of_hits(scatter.known.freq_Hz, scatter.known.freq_std_Hz);
  scatter.damping = scatter_of_hits(scatter.known.damping, scatter.known.damping_std);
  const auto test = [&](const ScatterOfHits& of, bool is_freq, bool& differs, double& p_value) {
    const HitSeries series = scatter.series(0, is_freq);
    const double trend = trend_deviate(series, peak_N);
    const bool any = of.deviate > kOnceIn1000 || trend > kSignificantTrend;
    const auto repeated = one_point ? std::optional(true) : hits_of_a_point_differ(series, points);
    differs = any && (repeated.value_or(false) || follows_a_law(series, peak_N));
    scatter.points_differ = scatter.points_differ || (any && !repeated);
    // Corrected for two tests: χ², and the larger of two slopes, each two-sided.
    p_value = std::min(1.0, 2 * std::min(upper_tail(of.deviate), 4 * upper_tail(trend)));
  };
  test(scatter.freq, true, scatter.freq_differs, scatter.freq_p);
  test(scatter.damping, false, scatter.damping_differs, scatter.damping_p);
  return scatter;
}

// The mean difference of the poles of the hits from the poles of their averages. Both come from the same window, so
// that its misfit cancels.
struct MeanChange {
  double freq_Hz = 0, damping = 0;
  double damping_std = 0;  // from the noise
};

std::optional<MeanChange> mean_change(const Known& known, const HitPoles& poles,
                                      const std::vector<std::size_t>& points) {
  std::vector<double> freq_Hz, freq_std_Hz, damping, damping_std;
  for (std::size_t i = 0; i < known.hits.size(); ++i) {
    const HitPole& average = poles.averages[points[known.hits[i]]];
    if (!average.known) continue;
    freq_Hz.push_back(known.freq_Hz[i] - average.pole.freq_Hz);
    freq_std_Hz.push_back(known.freq_std_Hz[i]);
    damping.push_back(known.damping[i] - average.pole.damping_ratio);
    damping_std.push_back(known.damping_std[i]);
  }
  if (freq_Hz.empty()) return std::nullopt;
  const ScatterOfHits of_damping = scatter_of_hits(damping, damping_std);
  return MeanChange{
      .freq_Hz = scatter_of_hits(freq_Hz, freq_std_Hz).mean, .damping = of_damping.mean, .damping_std = of_damping.std};
}

// Replaces the pole of the average by the mean of the hits' poles. Frequencies that differ raise the damping of the
// average. Damping ratios that differ leave its frequency unchanged.
void take_mean(Mode& mode, ModeScatter& scatter, const MeanChange& change) {
  if (std::abs(change.freq_Hz) > mode.pole.half_power_Hz() || -change.damping > 0.5 * mode.pole.damping_ratio) return;
  if (scatter.freq_differs) mode.pole.freq_Hz += change.freq_Hz;
  mode.pole.damping_ratio += change.damping;
  scatter.damping_shift = change.damping;
  scatter.damping_shift_std = change.damping_std;
}

void add_part(const ScatterOfHits& scatter, StdParts& parts, double& spread, double& total) {
  parts.hits = scatter.std_from_scatter;
  spread = scatter.spread;
  total = parts.total();
}

// The FRFs of a test, of its single hits, and the peak forces of the hits.
struct FittedHits {
  const FrfDataset& set;
  const HitFrfs& hits;
  const WindowedHitPoles& linear;
  const std::vector<double>& peak_N;
};

// Fits the modes of a window to each hit. Where the hits differ, takes the mean of their poles.
void fit_each_hit(const FittedHits& to, const ModeWindow& window, std::vector<Mode>& modes,
                  std::vector<ModeScatter>& scatter) {
  const auto& [set, hits, linear, peak_N] = to;
  const auto fitted = fitted_hit_poles(set, hits, modes, window, linear.modes_in_hits);
  const std::vector<Pole> before = window.poles(modes);
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    const std::size_t m = window.modes[i];
    const ModeScatter again = scatter_of_mode(fitted[i], peak_N, hits.points);
    if (!scatter[m].significant() || again.known.hits.size() < scatter[m].known.hits.size()) continue;
    scatter[m] = again;
    if (!again.significant()) continue;
    if (const auto change = mean_change(again.known, fitted[i], hits.points)) take_mean(modes[m], scatter[m], *change);
  }
  move_residues(set, window, before, modes);
}

// The frequencies, or the damping ratios, of the modes in the hits. windows  [modes] index of the mode's window
std::vector<RelativeHitValues> relative_values(const std::vector<ModeScatter>& scatter, const std::vector<Mode>& modes,
                                               const std::vector<std::size_t>& windows, bool is_freq) {
  std::vector<RelativeHitValues> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const HitSeries series = scatter[m].series(m, is_freq);
    const double own = is_freq ? modes[m].pole.freq_Hz : modes[m].pole.damping_ratio;
    RelativeHitValues& values = out.emplace_back();
    for (std::size_t i = 0; i < series.hits.size(); ++i) {
      values.value.push_back(series.value[i] / own);
      values.std.push_back(series.std[i] / own);
    }
    if (is_freq ? scatter[m].freq_differs : scatter[m].damping_differs)
      values.spread = (is_freq ? scatter[m].freq : scatter[m].damping).spread / own;
    values.window = windows[m];
  }
  return out;
}

// Gives modes that are too weak to show a scatter the scatter that the other modes share.
void add_shared_scatter(const std::vector<ModeScatter>& scatter, const std::vector<ModeWindow>& windows,
                        std::size_t hits, std::vector<Mode>& modes) {
  std::vector<std::size_t> window_of(modes.size());
  for (std::size_t w = 0; w < windows.size(); ++w) {
    for (const std::size_t m : windows[w].modes) window_of[m] = w;
  }
  for (const bool is_freq : {true, false}) {
    const std::vector<RelativeHitValues> values = relative_values(scatter, modes, window_of, is_freq);
    const SharedScatter shared = shared_scatter(values);
    if (shared.spread <= 0) continue;
    const auto scattering = std::count_if(values.begin(), values.end(), [](const auto& of) { return of.spread > 0; });
    const auto trends = std::count_if(modes.begin(), modes.end(), [&](const Mode& mode) {
      const auto& force = mode.amplitude;
      return (is_freq && mode.drift) || (force && (is_freq ? force->freq_follows : force->damping_follows));
    });
    const bool follows_law = 2 * trends > scattering;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const bool differs = is_freq ? scatter[m].freq_differs : scatter[m].damping_differs;
      if (differs || shared.probability[m] <= 0) continue;
      Mode& mode = modes[m];
      const double own = is_freq ? mode.pole.freq_Hz : mode.pole.damping_ratio;
      const double spread = own * shared.spread * std::sqrt(shared.probability[m]);
      double part = own * std_from_shared_scatter(values[m].std, hits, shared.spread, shared.probability[m]);
      if (follows_law) part = std::max(part, spread);  // as in explain_scatter(): a trend does not average out
      StdParts& parts = is_freq ? mode.freq_std_parts_Hz : mode.damping_std_parts;
      parts.hits = std::max(parts.hits, part);
      (is_freq ? mode.hit_scatter_Hz : mode.hit_scatter_damping) = spread;
      (is_freq ? mode.freq_std_Hz : mode.damping_std) = parts.total();
    }
  }
}

// Whether the mode is clear in a hit that does not determine its pole. Near a node, where the mode is not clear, no hit
// determines a pole.
bool is_undetermined(const HitFrfs& hits, const std::vector<std::size_t>& residue_of, const Mode& mode,
                     const HitPoles& poles) {
  for (std::size_t o = 0; o < residue_of.size(); ++o) {
    const std::size_t h = hits.set.channels[o].point;
    if (poles.hits[h].known) continue;
    const auto at_point = std::count(hits.points.begin(), hits.points.end(), hits.points[h]);
    const Residue& residue = mode.residues[residue_of[o]];
    if (std::abs(residue.value) > kClear * residue.std * std::sqrt(static_cast<double>(at_point))) return true;
  }
  return false;
}

}  // namespace

ScatterOfHits scatter_of_hits(const std::vector<double>& value, const std::vector<double>& std) {
  const RandomEffects all = random_effects(value, std, value.front());
  const auto degrees = static_cast<double>(value.size() - 1);
  const double noise2 = 1 / all.own_weights;
  const double scatter = std::sqrt(std::max(0.0, 1 / all.weights - noise2));
  return {.mean = all.mean,
          .std = std::sqrt(noise2),
          .std_from_scatter = scatter > 0 ? student_factor(degrees) * scatter : 0,
          .spread = std::sqrt(all.variance),
          .deviate = chi2_deviate(all.chi2, degrees)};
}

WindowedHitPoles windowed_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes) {
  WindowedHitPoles out;
  if (hits.points.size() < kMinHits || modes.empty()) return out;
  out.windows = mode_windows(set, modes);
  out.poles = linearised_hit_poles(set, hits, modes, out.windows);
  out.modes_in_hits = modes_with_residues_of_hits(set, hits, modes, out.poles);
  if (!out.modes_in_hits.empty()) out.poles = linearised_hit_poles(set, hits, modes, out.windows, out.modes_in_hits);
  return out;
}

void add_hit_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                     const std::vector<double>& peak_N, std::vector<Mode>& modes) {
  if (linear.windows.empty()) return;
  std::vector<ModeScatter> scatter;
  for (const HitPoles& poles : linear.poles) scatter.push_back(scatter_of_mode(poles, peak_N, hits.points));
  for (const ModeWindow& window : linear.windows) {
    if (std::any_of(window.modes.begin(), window.modes.end(), [&](std::size_t m) { return scatter[m].significant(); }))
      fit_each_hit({.set = set, .hits = hits, .linear = linear, .peak_N = peak_N}, window, modes, scatter);
  }
  std::vector<HitSeries> series;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    Mode& mode = modes[m];
    if (scatter[m].freq_differs) {
      add_part(scatter[m].freq, mode.freq_std_parts_Hz, mode.hit_scatter_Hz, mode.freq_std_Hz);
      mode.hit_scatter_freq_p = scatter[m].freq_p;
      series.push_back(scatter[m].series(m, true));
    }
    if (scatter[m].damping_differs) {
      add_part(scatter[m].damping, mode.damping_std_parts, mode.hit_scatter_damping, mode.damping_std);
      mode.hit_scatter_damping_p = scatter[m].damping_p;
      series.push_back(scatter[m].series(m, false));
    } else if (scatter[m].damping_shift != 0) {
      // The mean of the hits' poles may be far less certain than the mode, as in a close pair. The part of the hits is
      // therefore at most the shift.
      mode.damping_std_parts.hits = std::min(std::abs(scatter[m].damping_shift), scatter[m].damping_shift_std);
      mode.damping_std = mode.damping_std_parts.total();
    }
  }
  explain_scatter(series, peak_N, modes);
  add_shared_scatter(scatter, linear.windows, hits.points.size(), modes);
}

std::vector<double> without_imitating_modes(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                                            const std::vector<double>& peak_N, const std::vector<Mode>& modes) {
  const std::vector<std::size_t> residue_of = residue_indices(set, hits);
  const auto may_scatter = [](const ModeScatter& scatter) { return scatter.significant() || scatter.points_differ; };
  std::vector<char> imitating(modes.size(), 0);
  for (const ModeWindow& window : linear.windows) {
    for (const std::size_t m : spurious_modes_of_nonlinearity(set, hits, modes, window, linear.modes_in_hits))
      imitating[m] = 1;
    if (window.modes.size() < 2) continue;
    // Hits do not determine a pair that only imitates their scatter.
    const auto differs = [&](std::size_t m) {
      return linear.poles[m].differs_from_previous ||
             may_scatter(scatter_of_mode(linear.poles[m], peak_N, hits.points)) ||
             is_undetermined(hits, residue_of, modes[m], linear.poles[m]);
    };
    if (std::none_of(window.modes.begin(), window.modes.end(), differs)) continue;
    for (const std::size_t m : modes_from_hit_scatter(set, hits, modes, window, linear.modes_in_hits)) imitating[m] = 1;
  }
  if (std::none_of(imitating.begin(), imitating.end(), [](char one) { return one != 0; })) return {};
  std::vector<double> left_Hz;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (!imitating[m]) left_Hz.push_back(modes[m].pole.freq_Hz);
  }
  return left_Hz;
}

}  // namespace percuss::identify
