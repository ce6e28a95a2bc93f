#include "pipeline/stages/hidden_modes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "identify/modes_at_frequencies.hpp"
#include "identify/start/unmodelled_peaks.hpp"
#include "pipeline/stages/cancelled_tones.hpp"
#include "pipeline/stages/narrow_bands.hpp"

namespace percuss::pipeline {

bool may_hide_modes(const identify::FrfDataset& set, const TestSpectra& spectra,
                    const identify::IdentifyOptions& options, const std::vector<identify::Mode>& modes) {
  if (options.effort == identify::Effort::quick || !options.start_Hz.empty() || spectra.hits.empty()) return false;
  return set.points.size() == 1 ||
         std::any_of(modes.begin(), modes.end(), [](const identify::Mode& mode) { return mode.joint_misfit > 0; });
}

HiddenModeSearch add_hidden_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                                  const identify::FrfDataset& set,
                                  const std::function<const identify::HitFrfs&()>& hits, identify::Effort effort) {
  HiddenModeSearch out;
  std::copy_if(tones.begin(), tones.end(), std::back_inserter(out.wandering),
               [](const Tone& tone) { return tone.wanders; });
  std::vector<identify::Pole> poles = identify::unmodelled_poles(set, modes);
  const std::vector<identify::UnmodelledResonance> hidden = identify::unmodelled_resonances(set, modes, poles);
  if (hidden.empty()) {
    out.unmodelled = std::move(poles);
    return out;
  }
  const std::size_t known = modes.size();
  add_modes_at(hidden, modes, set, hits(), effort);
  std::vector<double> hidden_Hz;
  hidden_Hz.reserve(hidden.size());
  for (const identify::UnmodelledResonance& resonance : hidden) hidden_Hz.push_back(resonance.freq_Hz);
  const std::vector<Tone> more = tones_at(hidden_Hz, set, hits());
  out.wandering.insert(out.wandering.end(), more.begin(), more.end());
  if (modes.size() == known) out.unmodelled = std::move(poles);
  return out;
}

}  // namespace percuss::pipeline
