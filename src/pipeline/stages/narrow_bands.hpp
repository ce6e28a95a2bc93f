#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/effort.hpp"
#include "identify/model/mode.hpp"
#include "identify/modes_at_frequencies.hpp"

namespace percuss::pipeline {

/// Adds the modes that a narrow band around each of these resonances shows (identify::modes_at_frequencies), where
/// their residues agree from hit to hit. Where no point has the three hits that are necessary to see it, a mode must
/// die out within the record, which a tone does not. `modes` belong to `set`, the average of the hits, and ascend in
/// frequency. theory, section 4, "Peaks and stable poles of the residual"
void add_modes_at(const std::vector<identify::UnmodelledResonance>& resonances, std::vector<identify::Mode>& modes,
                  const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort);

}  // namespace percuss::pipeline
