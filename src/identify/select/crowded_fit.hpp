#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Crowds are fitted in so many FRFs at most: those of two accelerometers on a bat. The work grows with the FRFs, and the
/// shapes of more points separate close modes.
constexpr std::size_t kMaxCrowdFrfs = 2;

/// Half-power bandwidths of all modes over the width of the band.
double overlap_of(const std::vector<Pole>& poles, double band_width_Hz);

/// True for so many modes that overlap so far that peaks and stabilisation diagrams show only some of them.
bool are_crowded(const std::vector<Pole>& poles, double band_width_Hz);

/// The fit of all modes of a crowd together, from start values by vector fitting. Their number grows as long as the
/// likelihood does. A mode stays where the FRFs are less likely without it, however wide its ± is: without it, its
/// neighbours would be wrong. `found` are the modes found one by one, `stable` the stable poles and these modes.
/// Nothing where they do not tell of a crowd, for more FRFs, where no such fit converges within a limit of
/// work, and where its modes are no crowd. theory (4.26)
std::optional<JointFit> crowded_fit(const FrfDataset& set, const std::vector<Pole>& stable,
                                    const std::vector<Pole>& found);

}  // namespace percuss::identify
