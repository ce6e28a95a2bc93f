#pragma once
#include <vector>

#include "identify/hits/hit_poles.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mean of values that may scatter beyond their standard deviations (random effects, method of moments).
struct ScatterOfHits {
  double mean = 0;
  double std = 0;               // of the mean, from the values' own standard deviations
  double std_from_scatter = 0;  // of the mean, from the scatter beyond std, times Student's factor
  double spread = 0;            // between the values, beyond their standard deviations
  double deviate = 0;           // the scatter's χ² as a normal deviate
};
/// shapes  value and std equal, at least two.
ScatterOfHits scatter_of_hits(const std::vector<double>& value, const std::vector<double>& std);

/// The windows of a set of modes, and the modes' poles in each hit over these windows (linearised_hit_poles).
struct WindowedHitPoles {
  std::vector<ModeWindow> windows;
  std::vector<HitPoles> poles;        // [modes]
  std::vector<Mode> modes_in_hits{};  // [modes] from modes_with_residues_of_hits(); may be empty
};
WindowedHitPoles windowed_hit_poles(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes);

/// The frequencies of the modes, without modes that only imitate the scatter of another mode (modes_from_hit_scatter,
/// spurious_modes_of_nonlinearity). Empty where no mode imitates another: all modes are then kept.
/// linear  windowed_hit_poles of these modes
/// peak_N  [hits] in the order of the test
std::vector<double> without_imitating_modes(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                                            const std::vector<double>& peak_N, const std::vector<Mode>& modes);

/// Adds significant scatter between the hits to the modes' standard deviations, and explains it by a law over the hits'
/// forces or their order. The pole then becomes the mean of the hits' own poles, because the average of different
/// resonances is broader than each of them. If no point of a survey has several hits, scatter is significant only if it
/// follows such a law. Modes that are too weak to show a scatter get the scatter of the other modes, if these agree
/// (shared_scatter). Modes ascend in frequency and include modes outside the band.
/// linear  windowed_hit_poles of these modes
/// peak_N  [hits] in the order of the test
/// theory (4.19), (4.33)
void add_hit_scatter(const FrfDataset& set, const HitFrfs& hits, const WindowedHitPoles& linear,
                     const std::vector<double>& peak_N, std::vector<Mode>& modes);

}  // namespace percuss::identify
