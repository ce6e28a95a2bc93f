#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/hits/residue_ratios.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mode's pole as one hit gives it, with one standard deviation from the hit's own residual. `known` is false where
/// the hit does not determine the pole.
struct HitPole {
  Pole pole;
  double freq_std_Hz = 0, damping_std = 0;
  bool known = false;
  // At the pole of the test; only from linearised_hit_poles().
  ResidueRatio residue_ratio{};
  std::vector<HitResidue> residues{};  // [channels]
};

/// The poles of one mode in every hit. fitted_hit_poles() also gives the poles of the hits' averages, over the same
/// window. linearised_hit_poles() also gives whether the mode overlaps the previous mode of its window and the ratio of
/// their residues differs between the hits. Two fixed poles imitate one resonance that moves: their residues change
/// from hit to hit. A gain common to both does not count.
struct HitPoles {
  std::vector<HitPole> hits;
  std::vector<HitPole> averages;  // [points] of the average of the point's hits
  bool differs_from_previous = false;
};

/// Each mode's pole in each hit, [modes]: one Gauss–Newton step of the hit's own FRFs from the modes' poles, over each
/// mode's window. Modes fitted in one window are solved for together; the others are subtracted. `modes_in_hits`:
/// see hit_data().
std::vector<HitPoles> linearised_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                           const std::vector<ModeWindow>& windows,
                                           const std::vector<Mode>& modes_in_hits = {});

/// The same for the modes of one window, [window.modes], by complete local fits. They also follow poles too far from
/// the modes' poles for one Gauss–Newton step. If no point has several hits, the average of all points stands for the
/// average of each.
std::vector<HitPoles> fitted_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                       const ModeWindow& window, const std::vector<Mode>& modes_in_hits = {});

/// Whether a point has several hits. points: [hits] index of the hit's point
bool has_repeated_points(const std::vector<std::size_t>& points);

/// The modes with the residues of the single hits, [channels of hits.set], all fitted together at the modes' poles: a
/// blow in another direction changes the residues. `linear`: from linearised_hit_poles(). Empty if no residue ratios of
/// `linear` scatter clearly between the hits of a point: each hit then has the residues of the test, which are more
/// accurate.
std::vector<Mode> modes_with_residues_of_hits(const FrfDataset& set, const HitFrfs& hits,
                                              const std::vector<Mode>& modes, const std::vector<HitPoles>& linear);

/// The modes of a window that only imitate a resonance whose frequency differs between the hits. Without such a mode,
/// complete fits of the single hits are about as good as with it. They are also better than a fit of all modes with
/// poles common to the hits. At least one mode remains.
std::vector<std::size_t> modes_from_hit_scatter(const FrfDataset& set, const HitFrfs& hits,
                                                const std::vector<Mode>& modes, const ModeWindow& window,
                                                const std::vector<Mode>& modes_in_hits = {});

}  // namespace percuss::identify
