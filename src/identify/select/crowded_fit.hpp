#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Crowded modes are fitted together in at most this many FRFs, for example from two accelerometers on a bat. The work
/// grows with the number of FRFs, and the shapes of more points separate close modes.
constexpr std::size_t kMaxCrowdFrfs = 2;

/// Half-power bandwidths of all modes over the width of the band.
double overlap_of(const std::vector<Pole>& poles, double band_width_Hz);

/// Whether the modes are crowded: so many modes, with so much overlap, that peaks and stabilisation diagrams show only
/// some of them.
bool are_crowded(const std::vector<Pole>& poles, double band_width_Hz);

/// Fits all crowded modes together, from start values by vector fitting. The number of modes grows as long as the
/// likelihood does. However wide its ± is, a mode is kept if the FRFs are less likely without it: dropping it would
/// falsify its neighbours. `found` are the modes found one by one, `stable` the stable poles and these modes.
/// Returns nothing in these cases:
///   `stable` is not crowded, or its bandwidths cover more than the band
///   `found` holds too few modes, or the set more than kMaxCrowdFrfs FRFs
///   no fit converges within a limit of work, or the fitted modes are not crowded
///   the fitted modes follow a misfit: at an overlap below 1, more than a tenth of them are not well determined, or the
///   residual is smooth
/// theory (4.26)
std::optional<JointFit> crowded_fit(const FrfDataset& set, const std::vector<Pole>& stable,
                                    const std::vector<Pole>& found);

}  // namespace percuss::identify
