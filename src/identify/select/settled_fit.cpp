#include "identify/select/settled_fit.hpp"

#include <utility>

#include "identify/select/joint_selection.hpp"

namespace percuss::identify {
namespace {

constexpr int kDroppingRounds = 12;
constexpr int kJointSteps = 40;      // of a joint fit
constexpr double kTrialStep = 1e-3;  // tolerance of the poles while their number changes
constexpr double kTrialCost = 1e-4;  // … and relative decrease of the squares
constexpr double kFinalCost = 1e-9;  // relative decrease of the squares that ends a fit of the final modes

}  // namespace

std::optional<JointFit> settled_fit(const FrfDataset& set, std::vector<Pole> poles, JointFitBudget& budget,
                                    int final_fits, const std::vector<Pole>& held) {
  JointFitOptions options{.max_steps = kJointSteps,
                          .tolerance = kTrialStep,
                          .cost_tolerance = kTrialCost,
                          .test_real = false,
                          .held = held};
  for (int round = 0; round < kDroppingRounds && !poles.empty() && budget.allows(poles); ++round) {
    JointFit fit = budget.fit(poles, options);
    const bool converged = fit.converged;
    if (fit.residual.empty()) fit = fit_residues(set, fit.poles);
    poles = without_weakest(set, fit, Misfit::ignored);
    if (poles.size() < fit.poles.size()) continue;
    const bool final = options.tolerance < kTrialStep;
    if (final && converged) return fit;
    if (final && --final_fits > 0) continue;
    if (!converged) break;
    options.tolerance = JointFitOptions{}.tolerance;
    options.cost_tolerance = kFinalCost;
  }
  return std::nullopt;
}

JointFit with_tested_residues(const FrfDataset& set, const JointFit& fit, const std::vector<Pole>& held) {
  const JointFitOptions options{
      .max_steps = kJointSteps, .cost_tolerance = kFinalCost, .test_real = true, .held = held};
  JointFit tested = fit_jointly(set, fit.poles, options);
  return tested.converged ? tested : fit;
}

}  // namespace percuss::identify
