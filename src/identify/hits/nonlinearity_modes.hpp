#pragma once
#include <vector>

#include "identify/hits/hit_poles.hpp"

namespace percuss::identify {

/// Spurious modes of a window that come from a nonlinearity: friction, a stop, or a stiffness that depends on the
/// amplitude. They are weak, broad modes under a stronger one. Their residues differ between the hit that determines
/// them best and the other hits.
std::vector<std::size_t> spurious_modes_of_nonlinearity(const FrfDataset& set, const HitFrfs& hits,
                                                        const std::vector<Mode>& modes, const ModeWindow& window,
                                                        const std::vector<Mode>& modes_in_hits = {});

}  // namespace percuss::identify
