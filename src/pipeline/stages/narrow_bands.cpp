#include "pipeline/stages/narrow_bands.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "identify/hits/residue_coherence.hpp"
#include "identify/modes_at_frequencies.hpp"

namespace percuss::pipeline {
namespace {

bool ascending(const identify::Mode& a, const identify::Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; }

}  // namespace

void add_modes_at(const std::vector<double>& freq_Hz, std::vector<identify::Mode>& modes,
                  const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort) {
  const std::vector<identify::Mode> added = identify::modes_at_frequencies(set, modes, freq_Hz, effort);
  if (added.empty()) return;
  std::vector<identify::Mode> all;
  std::merge(modes.begin(), modes.end(), added.begin(), added.end(), std::back_inserter(all), ascending);
  const std::vector<bool> follows = identify::follow_force(set, hits, all);
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
