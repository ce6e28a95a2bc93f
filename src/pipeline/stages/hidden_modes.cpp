#include "pipeline/stages/hidden_modes.hpp"

#include <algorithm>
#include <iterator>

#include "identify/modes_at_frequencies.hpp"
#include "pipeline/stages/cancelled_tones.hpp"
#include "pipeline/stages/narrow_bands.hpp"

namespace percuss::pipeline {

bool may_hide_modes(const identify::FrfDataset& set, const TestSpectra& spectra,
                    const identify::IdentifyOptions& options) {
  return options.effort != identify::Effort::quick && options.start_Hz.empty() && set.points.size() == 1 &&
         !spectra.hits.empty();
}

std::vector<Tone> add_hidden_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                                   const identify::FrfDataset& set,
                                   const std::function<const identify::HitFrfs&()>& hits, identify::Effort effort) {
  std::vector<Tone> wandering;
  std::copy_if(tones.begin(), tones.end(), std::back_inserter(wandering),
               [](const Tone& tone) { return tone.wanders; });
  const std::vector<double> hidden_Hz = identify::unmodelled_frequencies_Hz(set, modes);
  if (hidden_Hz.empty()) return wandering;
  add_modes_at(hidden_Hz, modes, set, hits(), effort);
  const std::vector<Tone> more = tones_at(hidden_Hz, set, hits());
  wandering.insert(wandering.end(), more.begin(), more.end());
  return wandering;
}

}  // namespace percuss::pipeline
