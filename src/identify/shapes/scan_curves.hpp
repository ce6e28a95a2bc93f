#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>

namespace percuss::identify {

/// Fewer points do not determine a curve.
inline constexpr std::size_t kMinCurvePoints = 7;

/// The amplitudes at a point as predicted from the other points, [modes].
struct PredictedPoint {
  Eigen::VectorXd value;
  Eigen::VectorXd point_variance;  // of the mean of one point about its curve
  Eigen::VectorXd local;           // variance at the point over the variance of a typical one, at least 1
  Eigen::VectorXd curve_variance;  // of the curve
  double cost = 0;                 // BIC per point, sum over the modes
};

/// Predicts the amplitudes at a point from polynomials through the other points; BIC chooses the degree of each mode.
/// u  positions of the other points in −1 to 1, at least kMinCurvePoints; at_u: of the point
/// y  [other points, modes] amplitudes, in units of the largest near the point
/// Nothing where no polynomial is determined.
std::optional<PredictedPoint> predict_point(const Eigen::VectorXd& u, const Eigen::MatrixXd& y, double at_u);

}  // namespace percuss::identify
