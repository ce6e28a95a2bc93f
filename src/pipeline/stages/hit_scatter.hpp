#pragma once
#include <functional>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/identify.hpp"
#include "pipeline/stages/frf_averages.hpp"

namespace percuss::pipeline {

/// Adds the scatter between the accepted hits to the standard deviations of the modes and residues and describes its
/// trends (identify::add_hit_scatter, add_residue_scatter). Where a mode only imitates the scatter of another mode, the
/// modes are identified again without it, and `search` is called, which may add modes. This step is left out if the
/// options state the number of modes, or if a starting frequency names such a mode. `modes` belong to `set`, the
/// average of these hits, and are not limited to the band. `hits`: these hits one by one; called only if it is needed.
void add_scatter_between_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const std::function<const identify::HitFrfs&()>& hits,
                              const identify::IdentifyOptions& options, const std::function<void()>& search,
                              std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
