#include "identify/select/joint_fit_budget.hpp"

#include <algorithm>
#include <utility>

namespace percuss::identify {
namespace {

constexpr double kFixedEvaluations = 8;  // of a fit, in addition to those of its steps: residual, standard deviations

// About two seconds, and a fifth of a second for each FRF.
constexpr double kProducts = 1.5e9, kProductsPerFrf = 1.5e8;
// A survey needs more: where its budget ended early, clear modes were lost. Single records gained nothing from more.
constexpr std::size_t kSurveyPoints = 3;
constexpr double kSurveyProducts = 5 * kProducts;

}  // namespace

JointFitBudget::JointFitBudget(const FrfDataset& set)
    : set_(set),
      left_((set.points.size() < kSurveyPoints ? kProducts : kSurveyProducts) +
            kProductsPerFrf * static_cast<double>(set.channels.size())) {}

bool JointFitBudget::allows(const std::vector<Pole>& poles) const {
  return left_ >= kFixedEvaluations * products(poles);
}

JointFit JointFitBudget::fit(std::vector<Pole> poles, const JointFitOptions& options) {
  const double each = products(poles);
  JointFit fit = fit_jointly(set_, std::move(poles), options);
  left_ -= (kFixedEvaluations + fit.trials) * each;
  return fit;
}

double JointFitBudget::products(const std::vector<Pole>& poles) const {
  // FRFs share their columns where no record cuts a decay off.
  const bool common = std::all_of(poles.begin(), poles.end(), [&](const Pole& pole) {
    return decays_within_record(pole, set_.points.front(), set_.lines);
  });
  const auto parts = static_cast<double>(common ? 1 : set_.points.size());
  const double rows = 2 * static_cast<double>(set_.lines.count);
  const double columns = estimated_columns(poles);
  return parts * rows * columns * columns;
}

}  // namespace percuss::identify
