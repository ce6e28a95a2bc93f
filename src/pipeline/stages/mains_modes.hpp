#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Removes the modes that are remainders of hum. Such a mode is narrower than a spectral line and lies at a harmonic of
/// a tone of the mains. At every point, its residues change from hit to hit as if their phases were independent of the
/// force. The error of a harmonic's frequency leaves such a remainder when the harmonic is subtracted. `modes` belong
/// to `set`, the average of the hits. theory (1.11)
void remove_mains_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                        const identify::FrfDataset& set, const identify::HitFrfs& hits);

}  // namespace percuss::pipeline
