#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/identify.hpp"
#include "pipeline/findings/tones.hpp"
#include "pipeline/stages/frf_averages.hpp"

namespace percuss::pipeline {

/// Whether to search for modes that the fit of the whole band did not find. In a test of several points, only where the
/// joint fit failed for a mode: otherwise a narrow band shows weak modes that half of the points do not confirm.
bool may_hide_modes(const identify::FrfDataset& set, const TestSpectra& spectra,
                    const identify::IdentifyOptions& options, const std::vector<identify::Mode>& modes);

struct HiddenModeSearch {
  // Tones whose phase changes along the record, and resonances that the force does not explain.
  std::vector<Tone> wandering;
  std::optional<std::vector<identify::Pole>> unmodelled;  // result of unmodelled_poles(), if no mode was added
};

/// Adds modes at the resonances that `modes` do not describe, each from a narrow band around it (add_modes_at).
/// `wandering` holds the tones of `tones` that wander, and the resonances that the force does not explain (tones_at).
/// `hits` is called only where it is needed.
HiddenModeSearch add_hidden_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                                  const identify::FrfDataset& set,
                                  const std::function<const identify::HitFrfs&()>& hits, identify::Effort effort);

}  // namespace percuss::pipeline
