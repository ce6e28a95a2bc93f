#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/hits/hit_frfs.hpp"

namespace percuss::identify {

/// How well a mode's residues at one point agree between the hits.
struct ResidueCoherence {
  double coherence = 0;  // Σ |Σ w r|² / Σ w over Σ Σ w |r|², outer sums over the channels; 1 where all hits agree
  std::size_t hits = 0;
  double effective_hits = 0;  // (Σ w)²/Σ w², largest over the channels: less than `hits` if few have most of the weight
};

/// True where the residues of the hits agree: independent circular normal residues reach their coherence at most once
/// in a thousand times. Nothing with fewer than three hits, which do not show whether the phases are independent.
std::optional<bool> residues_agree(const ResidueCoherence& point);

/// As residues_agree(), but with effective_hits. For residues of about equal size with unequal variances, as the
/// remainder of a tone has: their coherence is high by chance if few hits have most of the weight.
std::optional<bool> residues_of_equal_size_agree(const ResidueCoherence& point);

/// [points of set] for the mode window.modes[mode]. Each hit is fitted over the window at the modes' poles, which gives
/// a residue r per channel; w is one over the variance of r. The hits are compared with their own mean in each channel,
/// not with the residues of the test: these are fitted to the same hits, so the part of r along them agrees better than
/// independent residues do. The flanks of other modes raise the coherence of an FRF, but not this one. theory (1.11)
std::vector<ResidueCoherence> residue_coherence(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                std::size_t mode);

/// [modes] whether the residues of the hits agree at some point; nothing where no point can tell. Two hits of a
/// point can only show that the residues do not agree: such a mode is doubtful.
std::vector<std::optional<bool>> residues_agree_between_hits(const FrfDataset& set, const HitFrfs& hits,
                                                             const std::vector<Mode>& modes);

}  // namespace percuss::identify
