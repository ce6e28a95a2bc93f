#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {

/// The correlation along frequency of a window's residual.
struct ResidualCorrelation {
  std::vector<double> at_lag;  // [lags] from 1 up to the first that is not positive, beyond what white noise shows
  double deviate = 0;          // of the first lags from white noise, one-sided, as a normal deviate
  double lines = 1;            // that count as one: 1 + 2 Σ at_lag
};

/// noise  [channels] rms of the residual, of the same set. White noise loses the part that the fit follows, so that its
/// residual correlates as well, negatively as a rule; that is subtracted.
ResidualCorrelation residual_correlation(const ProjectedState& state, const Eigen::MatrixXd& polynomial,
                                         const Eigen::VectorXd& noise);

/// Σ_k conj(left(k, i))·right(k + lag, j). shapes  left [lines, a], right [lines, b], result [a, b].
Eigen::MatrixXcd lagged_product(const Eigen::MatrixXcd& left, const Eigen::MatrixXcd& right, Eigen::Index lag);

}  // namespace percuss::identify
