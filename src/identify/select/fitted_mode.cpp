#include "identify/select/fitted_mode.hpp"

#include <algorithm>
#include <cmath>

#include "identify/noise/force_noise.hpp"
#include "identify/select/frequency_scatter.hpp"
#include "identify/select/mode_acceptance.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

Mode mode_of(const FrfDataset& set, const LocalFit& fit, std::size_t m) {
  const auto i = static_cast<Index>(m);
  const Pole& pole = fit.poles[m];
  Mode mode{.pole = pole,
            .freq_std_Hz = std::hypot(fit.freq_std_Hz(i), kRounding * pole.freq_Hz),
            .damping_std = std::hypot(fit.damping_std(i), kRoundingDamping * pole.damping_ratio)};
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    mode.residues.push_back({.point = set.channels[o].point,
                             .channel = set.channels[o].channel,
                             .value = fit.residues(static_cast<Index>(o), i),
                             .std = fit.residue_std(static_cast<Index>(o), i),
                             .relative_std = gain_amplitude_std(set, set.channels[o].point, mode.pole.freq_Hz)});
  }
  return mode;
}

void apply_freq_scatter(FittedMode& found, const ScatteredMode& scattered) {
  found.noise = scattered.noise;
  Mode& mode = found.mode;
  mode.pole = scattered.pole;
  mode.freq_std_Hz = scattered.freq_std_Hz;
  mode.damping_std = scattered.damping_std;
  mode.freq_scatter_Hz = scattered.freq_scatter_Hz;
  for (std::size_t o = 0; o < mode.residues.size(); ++o) {
    mode.residues[o].value = scattered.residues[o];
    mode.residues[o].std = scattered.residue_std[o];
    mode.residues[o].own_pole = scattered.own_poles[o];
  }
}

}  // namespace

std::vector<FittedMode> fitted_modes(const WindowedFit& fit) {
  std::vector<FittedMode> modes;
  for (const FitGroup& group : fit.groups()) {
    const auto scattered = scattered_modes(fit, group);
    for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
      modes.push_back({.mode = mode_of(fit.set(), group.fit, m),
                       .peak_to_residual = peak_to_residual(fit, group, m),
                       .first = group.first,
                       .count = group.count,
                       .noise = group.fit.noise,
                       .unknowns_per_channel = 2 * (group.fit.poles.size() + LocalFitOptions{}.residual_terms)});
      if (!scattered.empty()) apply_freq_scatter(modes.back(), scattered[m]);
    }
  }
  // Poles that are fitted together may have exchanged places.
  std::sort(modes.begin(), modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
  return modes;
}

std::vector<Pole> poles_of(const std::vector<FittedMode>& modes) {
  std::vector<Pole> poles;
  poles.reserve(modes.size());
  for (const FittedMode& mode : modes) poles.push_back(mode.mode.pole);
  return poles;
}

}  // namespace percuss::identify
