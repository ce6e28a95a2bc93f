#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// A second search where the first one left something unexplained: a resonance in the residual, a mode that a fit of
/// all modes together does not describe, or a frequency that scatters between points. It starts from the stable poles
/// of all FRFs (stable_poles) and fits all modes together, so that crowded and heavily damped modes need no windows of
/// their own. Insignificant modes are dropped one by one; the residual's correlation between lines, which is misfit,
/// counts against a mode's significance. Replaces `modes` only where the new modes explain significantly more.
/// `residual` belongs to a fit of all `modes` together, [channels][lines]; empty: unknown.
/// theory (4.21)
void search_jointly(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual,
                    std::vector<FittedMode>& modes);

}  // namespace percuss::identify
