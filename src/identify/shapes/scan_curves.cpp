#include "identify/shapes/scan_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/math/linear_algebra.hpp"
#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMinCurveStd = 1e-3;  // of the largest amplitude near the point: polynomials follow a shape no better
constexpr Index kMaxCurveDegree = 5;
constexpr Index kMinFreePoints = 6;  // points of a curve beyond its degree
constexpr double kMinPivotOfCurve = 1e-9;

// The polynomials of one degree through the kept points, [modes], at the point that is left out.
struct CurvesOfDegree {
  Index degree = 0;
  VectorXd value, slope;              // at the point
  double leverage = 0;                // variance of a value over the variance of one kept point
  VectorXd squares;                   // of the residuals, sum over the kept points
  VectorXd mean_value2, mean_slope2;  // of the curves over the kept points
};

MatrixXd powers_of(const VectorXd& u, Index degree) {
  MatrixXd powers(u.size(), degree + 1);
  powers.col(0).setOnes();
  for (Index i = 1; i <= degree; ++i) powers.col(i) = powers.col(i - 1).cwiseProduct(u);
  return powers;
}

MatrixXd slopes_of(const MatrixXd& powers) {
  MatrixXd slopes = MatrixXd::Zero(powers.rows(), powers.cols());
  for (Index i = 1; i < powers.cols(); ++i) slopes.col(i) = static_cast<double>(i) * powers.col(i - 1);
  return slopes;
}

std::optional<CurvesOfDegree> curves_of_degree(const VectorXd& u, const MatrixXd& y, double at_u, Index degree) {
  const MatrixXd powers = powers_of(u, degree);
  const auto inverse = left_inverse(powers, kMinPivotOfCurve);
  if (!inverse) return std::nullopt;
  const MatrixXd coefficients = *inverse * y, fitted = powers * coefficients;
  const MatrixXd at = powers_of(VectorXd::Constant(1, at_u), degree);
  return CurvesOfDegree{.degree = degree,
                        .value = (at * coefficients).transpose(),
                        .slope = (slopes_of(at) * coefficients).transpose(),
                        .leverage = (at * *inverse).squaredNorm(),
                        .squares = (y - fitted).colwise().squaredNorm().transpose(),
                        .mean_value2 = fitted.colwise().squaredNorm().transpose() / static_cast<double>(u.size()),
                        .mean_slope2 = (slopes_of(powers) * coefficients).colwise().squaredNorm().transpose() /
                                       static_cast<double>(u.size())};
}

struct ChosenDegree {
  std::size_t index = 0;  // of the fit
  double cost = std::numeric_limits<double>::infinity();
};

// The fit whose BIC per point is least for a mode.
ChosenDegree degree_by_bic(const std::vector<CurvesOfDegree>& fits, Index mode, double points) {
  ChosenDegree best;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const double mean2 = std::max(fits[i].squares(mode) / points, kMinCurveStd * kMinCurveStd);
    const double cost = std::log(mean2) + static_cast<double>(fits[i].degree + 1) * std::log(points) / points;
    if (cost < best.cost) best = {.index = i, .cost = cost};
  }
  return best;
}

// Predicts the amplitudes at the point from a curve for each mode.
PredictedPoint predicted_by(const std::vector<CurvesOfDegree>& fits, Index points, Index modes) {
  const auto n = static_cast<double>(points);
  const VectorXd none = VectorXd::Zero(modes);
  PredictedPoint out{.value = none, .point_variance = none, .local = none, .curve_variance = none};
  VectorXd variance(modes), slope2(modes), value2(modes), here_slope2(modes), leverage(modes), model(modes);
  std::vector<double> placement2;
  for (Index m = 0; m < modes; ++m) {
    const auto [best, cost] = degree_by_bic(fits, m, n);
    out.cost += cost;
    const CurvesOfDegree& fit = fits[best];
    // The neighbouring degree shows how far the prediction depends on the choice.
    const CurvesOfDegree& other = fits[best + 1 < fits.size() ? best + 1 : best > 0 ? best - 1 : best];
    out.value(m) = fit.value(m);
    variance(m) = fit.squares(m) / static_cast<double>(points - fit.degree - 1);
    slope2(m) = fit.mean_slope2(m);
    value2(m) = fit.mean_value2(m);
    here_slope2(m) = fit.slope(m) * fit.slope(m);
    leverage(m) = std::max(fit.leverage, best + 1 < fits.size() ? other.leverage : 0);
    model(m) = other.value(m) - fit.value(m);
    if (slope2(m) > 0) placement2.push_back(variance(m) / slope2(m));
  }
  // Errors of the places are common to all modes. They matter more where the shape is steep; errors of the direction,
  // where the amplitude is large.
  const double common2 = placement2.empty() ? 0 : median(placement2);
  for (Index m = 0; m < modes; ++m) {
    const double typical = std::max(variance(m), common2 * slope2(m));
    const double steep = slope2(m) > 0 ? here_slope2(m) / slope2(m) : 1;
    const double high = value2(m) > 0 ? out.value(m) * out.value(m) / value2(m) : 1;
    out.local(m) = std::max({1.0, steep, high});
    out.point_variance(m) = typical * out.local(m);
    out.curve_variance(m) = typical * leverage(m) + model(m) * model(m) + kMinCurveStd * kMinCurveStd;
  }
  return out;
}

}  // namespace

std::optional<PredictedPoint> predict_point(const VectorXd& u, const MatrixXd& y, double at_u) {
  std::vector<CurvesOfDegree> fits;
  for (Index degree = 1; degree <= std::min(kMaxCurveDegree, u.size() - kMinFreePoints); ++degree) {
    auto fit = curves_of_degree(u, y, at_u, degree);
    if (!fit) break;
    fits.push_back(std::move(*fit));
  }
  if (fits.empty()) return std::nullopt;
  return predicted_by(fits, u.size(), y.cols());
}

}  // namespace percuss::identify
