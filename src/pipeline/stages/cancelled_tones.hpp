#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/effort.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Whether the channels of the test can cancel a tone that wanders: several channels of one point, and three hits.
bool can_cancel_tones(const identify::FrfDataset& set, const identify::HitFrfs& hits);

/// The tones among these frequencies: the force does not explain the responses there. Such a tone wanders too much to
/// be found in the time signals. None where the channels cannot cancel tones.
std::vector<Tone> tones_at(const std::vector<double>& freq_Hz, const identify::FrfDataset& set,
                           const identify::HitFrfs& hits);

/// Refits the modes near each wandering tone, in the combinations of the channels in which the tone cancels, and adds
/// modes that the tone hides. Subtracting a fitted sinusoid cannot remove such a tone. But the tone reaches the
/// channels in one ratio, whatever its phase. A mode takes the values of a combination where their standard deviation
/// is clearly smaller. A mode that is added must follow the force from hit to hit. Changes nothing where the channels
/// cannot cancel tones. `modes` belong to `set`, the average of the hits, and ascend in frequency. theory (4.25)
void refit_modes_near_tones(std::vector<identify::Mode>& modes, const std::vector<Tone>& tones,
                            const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort);

}  // namespace percuss::pipeline
