#pragma once
#include <vector>

#include "identify/hits/hit_scatter.hpp"

namespace percuss::identify {

/// Adds the scatter of the residues between the hits at a point, where it is significant. What is common to the
/// channels, as for hits beside the point, goes to Residue::relative_std. What differs between them goes to
/// Residue::std: a hit in another direction excites the two orientations of a tube's mode in another proportion. A
/// point with one hit shows no scatter.
/// theory (4.27), (4.30)
/// linear  windowed_hit_poles of these modes
void add_residue_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                         std::vector<Mode>& modes);

}  // namespace percuss::identify
