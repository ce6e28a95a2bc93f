#pragma once
#include <cstddef>
#include <vector>

#include "identify/hits/hit_frfs.hpp"

namespace percuss::identify {

/// How well a mode's residues at one point agree between the hits.
struct ResidueCoherence {
  double coherence = 0;  // |Σ w r|² / (Σ w · Σ w |r|²) of the residues r relative to the test's; 1 where all are equal
  std::size_t hits = 0;
};

/// [points of set] for the mode window.modes[mode]. Each hit is fitted over the window at the modes' poles; w is one
/// over the variance of r. The flanks of other modes raise the coherence of an FRF, but not this one.
/// theory (1.11)
std::vector<ResidueCoherence> residue_coherence(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                std::size_t mode);

}  // namespace percuss::identify
