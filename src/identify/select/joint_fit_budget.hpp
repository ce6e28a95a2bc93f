#pragma once
#include <vector>

#include "identify/fit/joint_fit.hpp"

namespace percuss::identify {

/// Columns of the matrix of a joint fit of `poles`, for estimates of its work: two for each mode, and about 10 for the
/// background. (The six terms of out_of_band_terms() with complex coefficients have 12; another number here would move
/// the limits of work.)
inline double estimated_columns(const std::vector<Pole>& poles) { return static_cast<double>(2 * poles.size() + 10); }

/// Joint fits within a limit of their work, which is counted in products: the same on every machine. Without a limit,
/// fits of hundreds of modes, or of misfitting ones, would take minutes.
class JointFitBudget {
 public:
  explicit JointFitBudget(const FrfDataset& set);

  /// Whether one more fit of these modes is affordable.
  bool allows(const std::vector<Pole>& poles) const;

  /// fit_jointly, its work subtracted from the budget.
  JointFit fit(std::vector<Pole> poles, const JointFitOptions& options);

 private:
  // Products of one evaluation of the model.
  double products(const std::vector<Pole>& poles) const;

  const FrfDataset& set_;
  double left_;
};

}  // namespace percuss::identify
