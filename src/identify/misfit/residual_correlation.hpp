#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {

/// The correlation along frequency of a window's residual.
struct ResidualCorrelation {
  /// [lags] from 1 on, without the correlation that white noise leaves. Ends before the first lag above 3 that is not
  /// positive.
  std::vector<double> at_lag;
  double deviate = 0;  // departure of the first lags from white noise, as a one-sided normal deviate
  double lines = 1;    // lines that count as one independent line: 1 + 2 Σ at_lag
};

/// The fit follows a part of white noise, so that the residual of white noise correlates too, negatively as a rule.
/// This correlation is subtracted.
/// shapes  polynomial [lines, terms], the orthonormal background columns; noise [channels], the rms of the residual
ResidualCorrelation residual_correlation(const ProjectedState& state, const Eigen::MatrixXd& polynomial,
                                         const Eigen::VectorXd& noise);

/// Σ_k conj(left(k, i))·right(k + lag, j). shapes  left [lines, a], right [lines, b], result [a, b].
Eigen::MatrixXcd lagged_product(const Eigen::MatrixXcd& left, const Eigen::MatrixXcd& right, Eigen::Index lag);

}  // namespace percuss::identify
