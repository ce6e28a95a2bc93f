#pragma once
#include <vector>

#include "identify/hits/hit_scatter.hpp"

namespace percuss::identify {

/// Adds the scatter of the residues between the hits at a point to Residue::relative_std, where it is significant. Hits
/// beside the point or in another direction cause it. A point with one hit shows none.
/// theory (4.27)
/// linear  windowed_hit_poles of these modes
void add_residue_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                         std::vector<Mode>& modes);

}  // namespace percuss::identify
