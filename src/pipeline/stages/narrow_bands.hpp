#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/effort.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// Adds the modes that a narrow band around each of these frequencies shows (identify::modes_at_frequencies), where
/// their residues follow the force from hit to hit. Three hits of a point are necessary to see it. `modes` belong to
/// `set`, the average of the hits, and ascend in frequency. theory (4.21)
void add_modes_at(const std::vector<double>& freq_Hz, std::vector<identify::Mode>& modes,
                  const identify::FrfDataset& set, const identify::HitFrfs& hits, identify::Effort effort);

}  // namespace percuss::pipeline
