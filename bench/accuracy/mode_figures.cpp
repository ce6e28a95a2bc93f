#include "mode_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::accuracy {
namespace {

struct ModeTally {
  double freq = 0, freq_bound = 0, damping = 0, damping_bound = 0;  // sums of squares
  double found = 0, sought = 0, spurious = 0, covered = 0;

  void add(const ModeTally& other) {
    freq += other.freq;
    freq_bound += other.freq_bound;
    damping += other.damping;
    damping_bound += other.damping_bound;
    found += other.found;
    sought += other.sought;
    spurious += other.spurious;
    covered += other.covered;
  }
  void add(const identify::Mode& mode, const synth::Truth& truth, std::size_t m) {
    const synth::SynthMode& true_mode = truth.spec.modes[m];
    const double df_Hz = mode.pole.freq_Hz - true_mode.freq_Hz;
    const double dz = mode.pole.damping_ratio - true_mode.damping_ratio;
    freq += std::pow(df_Hz / true_mode.freq_Hz, 2);
    freq_bound += std::pow(df_Hz / truth.bound->freq_std_Hz[m], 2);  // (1)
    damping += std::pow(dz / true_mode.damping_ratio, 2);
    damping_bound += std::pow(dz / truth.bound->damping_ratio_std[m], 2);
    covered += std::abs(df_Hz) <= kInterval * mode.freq_std_Hz ? 0.5 : 0;
    covered += std::abs(dz) <= kInterval * mode.damping_std ? 0.5 : 0;
    ++found;
  }
};

ModeTally matched(const std::vector<identify::Mode>& modes, const synth::Truth& truth) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;  // distance, true mode, mode
  for (std::size_t m = 0; m < truth.spec.modes.size(); ++m) {
    const synth::SynthMode& sought = truth.spec.modes[m];
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const double distance_Hz = std::abs(modes[k].pole.freq_Hz - sought.freq_Hz);
      if (distance_Hz <= 2 * sought.damping_ratio * sought.freq_Hz) pairs.emplace_back(distance_Hz, m, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> has(truth.spec.modes.size()), taken(modes.size());
  ModeTally tally{.sought = static_cast<double>(truth.spec.modes.size()),
                  .spurious = static_cast<double>(modes.size())};
  for (const auto& [distance_Hz, m, k] : pairs) {
    if (has[m] || taken[k]) continue;
    has[m] = taken[k] = true;
    --tally.spurious;
    tally.add(modes[k], truth, m);
  }
  return tally;
}

Figure figure_from(const ModeTally& all, identify::Effort effort, std::size_t runs) {
  return {.method = name_of(effort),
          .label = {},
          .error = 1e6 * std::sqrt(all.freq / all.found),
          .over_bound = std::sqrt(all.freq_bound / all.found),
          .more = {shown_figure(100 * std::sqrt(all.damping / all.found)),
                   shown_figure(std::sqrt(all.damping_bound / all.found)),
                   fmt::format("{:.1f}", 100 * all.covered / all.found),
                   fmt::format("{:.1f}", 100 * all.found / all.sought),
                   fmt::format("{:.2f}", all.spurious / static_cast<double>(runs))}};
}

}  // namespace

std::vector<Figure> mode_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth) {
  std::vector<Figure> figures;
  for (const identify::Effort effort : kEfforts) {
    std::vector<ModeTally> each(runs.size());
    parallel_for(runs.size(), 0, [&](std::size_t i) {
      const pipeline::Analysis analysis(
          runs[i].second,
          {.band_Hz = {{truth.spec.band_low_Hz, truth.spec.band_high_Hz}}, .modes = {.effort = effort}, .threads = 1});
      each[i] = matched(analysis.modes(), truth);
    });
    ModeTally all;
    for (const ModeTally& one : each) all.add(one);
    figures.push_back(figure_from(all, effort, runs.size()));
  }
  return figures;
}

}  // namespace percuss::accuracy
