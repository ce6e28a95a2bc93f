#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Removes the modes that are remainders of hum: narrower than a spectral line, at a harmonic of a tone of the mains,
/// and with residues that follow the force from hit to hit at no point: their coherence could come from independent
/// phases. Subtracting a harmonic from responses with noise leaves such a remainder, because the harmonic's frequency
/// has an error. `modes` belong to `set`, the average of the hits. theory (1.10)
void remove_mains_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                        const identify::FrfDataset& set, const identify::HitFrfs& hits);

}  // namespace percuss::pipeline
