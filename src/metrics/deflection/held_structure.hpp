#pragma once
#include <Eigen/LU>

#include "metrics/deflection/baseline_drift.hpp"

namespace percuss::metrics {

/// Bias and drift from N values that are zero for a held structure: the update of the line in `rest` by least squares.
/// Not held if χ² of the values is not below max_chi2.
/// value = by_line·(bias, drift), with the covariance `noise`
template <int N>
ZeroMeanCorrection correction_by_zeros(const Eigen::Matrix<double, N, 1>& value,
                                       const Eigen::Matrix<double, N, 2>& by_line,
                                       const Eigen::Matrix<double, N, N>& noise, const BaselineEstimate& rest,
                                       double max_chi2) {
  ZeroMeanCorrection out{.bias = Eigen::Vector2d::Zero(), .covariance = rest.covariance};
  const Eigen::Matrix<double, N, N> spread = by_line * rest.covariance * by_line.transpose() + noise;
  const Eigen::Matrix<double, N, N> weight = spread.inverse();
  out.held = weight.allFinite() && value.dot(weight * value) < max_chi2;
  if (!out.held) return out;
  const Eigen::Matrix<double, 2, N> gain = rest.covariance * by_line.transpose() * weight;
  out.bias = gain * value;
  out.covariance = rest.covariance - gain * by_line * rest.covariance;
  return out;
}

}  // namespace percuss::metrics
