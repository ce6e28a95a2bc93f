#pragma once
#include <functional>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Removes the modes that are remainders of tones. Such a mode is at most two spectral lines broad and lies at a tone,
/// at a harmonic of the mains, or near a tone that wanders. At every point, its residues change from hit to hit as if
/// their phases were independent of the force. A tone that wanders, or whose frequency has an error, leaves such a
/// remainder when it is subtracted. `modes` belong to `set`, the average of the hits. `hits` is called only if a mode
/// may be such a remainder. theory (1.11)
void remove_tone_modes(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                       const identify::FrfDataset& set, const std::function<const identify::HitFrfs&()>& hits);

}  // namespace percuss::pipeline
