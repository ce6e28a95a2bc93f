#include "pipeline/stages/narrow_bands.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "identify/hits/residue_coherence.hpp"
#include "identify/modes_at_frequencies.hpp"

namespace percuss::pipeline {
namespace {

bool ascending(const identify::Mode& a, const identify::Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; }

// For each of `modes`: whether its residues follow the force at some point.
std::vector<bool> follow_force(const identify::FrfDataset& set, const identify::HitFrfs& hits,
                               const std::vector<identify::Mode>& modes) {
  std::vector<bool> follows(modes.size());
  for (const identify::ModeWindow& window : identify::mode_windows(set, modes)) {
    for (std::size_t i = 0; i < window.modes.size(); ++i) {
      const auto points = identify::residue_coherence(set, hits, modes, window, i);
      follows[window.modes[i]] = std::any_of(points.begin(), points.end(), [](const identify::ResidueCoherence& point) {
        return identify::follows_force(point).value_or(false);
      });
    }
  }
  return follows;
}

}  // namespace

void add_modes_at(const std::vector<double>& freq_Hz, std::vector<identify::Mode>& modes,
                  const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort) {
  const std::vector<identify::Mode> added = identify::modes_at_frequencies(set, modes, freq_Hz, effort);
  if (added.empty()) return;
  std::vector<identify::Mode> all;
  std::merge(modes.begin(), modes.end(), added.begin(), added.end(), std::back_inserter(all), ascending);
  const std::vector<bool> follows = follow_force(set, hits, all);
  const auto is_added = [&](const identify::Mode& mode) {
    return std::any_of(added.begin(), added.end(),
                       [&](const identify::Mode& other) { return other.pole == mode.pole; });
  };
  modes.clear();
  for (std::size_t m = 0; m < all.size(); ++m) {
    if (follows[m] || !is_added(all[m])) modes.push_back(std::move(all[m]));
  }
}

}  // namespace percuss::pipeline
