#pragma once
#include <optional>
#include <vector>

#include "identify/fit/joint_fit.hpp"
#include "identify/select/joint_fit_budget.hpp"

namespace percuss::identify {

/// The joint fit from these poles without insignificant modes; nothing where it does not settle. A coarse tolerance
/// serves until no more modes are dropped. A coarse fit that neither converges nor drops a mode is not repeated. A fit
/// at the final tolerance is continued until it converges, in at most `final_fits` fits. `held`: see JointFitOptions.
std::optional<JointFit> settled_fit(const FrfDataset& set, std::vector<Pole> poles, JointFitBudget& budget,
                                    int final_fits = 1, const std::vector<Pole>& held = {});

/// Fits the same modes again, with real residues where the data allow it. Returns `fit` if the new fit does not
/// converge.
JointFit with_tested_residues(const FrfDataset& set, const JointFit& fit, const std::vector<Pole>& held = {});

}  // namespace percuss::identify
