#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// A second search where the first one left something unexplained: a frequency that scatters between points, a misfit
/// around a mode, or a resonance in the residual. The misfit must be significant (misfit_of). Resonances are searched
/// only in a residual that over some block of lines is smoother than noise (smooth_somewhere). Misfit and resonance
/// must be large enough to disturb a mode (is_material). The search fits all modes together (best_joint_fit), so that
/// crowded and heavily damped modes need no windows of their own. Replaces `modes` only where the new modes explain
/// significantly more (min_gain_beside).
/// `residual` belongs to a fit of all `modes` together, [channels][lines]; empty: unknown.
/// theory (4.21)
void search_jointly(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual,
                    std::vector<FittedMode>& modes);

}  // namespace percuss::identify
