#include "pipeline/stages/narrow_bands.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

#include "identify/hits/residue_coherence.hpp"
#include "identify/model/modal_model.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kDecayedAmplitude = 0.1;      // left at the record's end; a steady tone keeps all of it
constexpr double kMinDampingSignificance = 6;  // standard deviations

bool decays_clearly(const identify::FrfDataset& set, const identify::Mode& mode) {
  return mode.damping_std * kMinDampingSignificance < mode.pole.damping_ratio &&
         identify::remaining_amplitude(mode.pole, set.lines, set.window_decay_per_s()) < kDecayedAmplitude;
}

bool ascending(const identify::Mode& a, const identify::Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; }

}  // namespace

void add_modes_at(const std::vector<identify::UnmodelledResonance>& resonances, std::vector<identify::Mode>& modes,
                  const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort) {
  const std::vector<identify::Mode> added = identify::modes_at_frequencies(set, modes, resonances, effort);
  if (added.empty()) return;
  std::vector<identify::Mode> all;
  std::merge(modes.begin(), modes.end(), added.begin(), added.end(), std::back_inserter(all), ascending);
  const std::vector<std::optional<bool>> follows = identify::residues_agree_between_hits(set, hits, all);
  const auto is_added = [&](const identify::Mode& mode) {
    return std::any_of(added.begin(), added.end(),
                       [&](const identify::Mode& other) { return other.pole == mode.pole; });
  };
  modes.clear();
  for (std::size_t m = 0; m < all.size(); ++m) {
    if (follows[m].value_or(decays_clearly(set, all[m])) || !is_added(all[m])) modes.push_back(std::move(all[m]));
  }
}

}  // namespace percuss::pipeline
