#include "core/math/levenberg_marquardt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/math/linear_algebra.hpp"

namespace percuss::levenberg_marquardt_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Stop = LevenbergMarquardtStop;

constexpr double kRounding = 1e-14;     // relative; about a hundred roundings
constexpr double kCostRounding = 1e-6;  // standard deviations; rounding of the cost hides steps below √(30 ε) = 8e-8
constexpr double kCertified = 1e-10;    // relative; the certified values have 11 digits
constexpr double kStdTolerance = 1e-6;  // relative; follows the parameters' own error

VectorXd vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), std::ssize(values));
}

// r = A·x − b has its minimum where AᵀA·x = Aᵀb.
TEST(LevenbergMarquardt, SolvesALinearProblem) {
  const MatrixXd a = (MatrixXd(3, 2) << 1, 2, 3, 4, 5, 7).finished();
  const VectorXd b = vector({1, -2, 0.5});
  VectorXd x = VectorXd::Zero(2);
  const auto summary = levenberg_marquardt(
      x, [&](const VectorXd& p) { return VectorXd(a * p - b); }, [&](const VectorXd&) { return a; });
  EXPECT_TRUE(summary.converged());
  const VectorXd expected = least_squares(a, b);
  EXPECT_LT((x - expected).norm(), kCostRounding);
}

// Rosenbrock's valley: r = (10(y − x²), 1 − x) vanishes at (1, 1).
TEST(LevenbergMarquardt, FollowsRosenbrocksValley) {
  VectorXd x = vector({-1.2, 1});
  const auto summary = levenberg_marquardt(
      x,
      [](const VectorXd& p) {
        return vector({10 * (p[1] - p[0] * p[0]), 1 - p[0]});
      },
      [](const VectorXd& p) { return MatrixXd((MatrixXd(2, 2) << -20 * p[0], 10, -1, 0).finished()); });
  EXPECT_TRUE(summary.converged());
  EXPECT_NEAR(x[0], 1, kRounding);
  EXPECT_NEAR(x[1], 1, kRounding);
}

// cost = 10⁶ + x², with a rounding error that grows from trial to trial: near x = 0, no trial lowers the cost. The
// curvature is stated twice too large, so that each step goes half the way.
class RoundedProblem : public LeastSquaresProblem {
 public:
  double cost() const override { return cost_; }
  const NormalEquations& normal_equations() override {
    normal_ = {.matrix = MatrixXd::Constant(1, 1, 2), .right = VectorXd::Constant(1, -x_)};
    return normal_;
  }
  std::optional<double> try_step(const VectorXd& step) override {
    trial_ = x_ + step(0);
    rounding_ += 1e-9;
    trial_cost_ = 1e6 + trial_ * trial_ + rounding_;
    return trial_cost_;
  }
  void accept() override {
    x_ = trial_;
    cost_ = trial_cost_;
  }

 private:
  double x_ = 1, cost_ = 1e6 + 1, trial_ = 0, trial_cost_ = 0, rounding_ = 0;
  NormalEquations normal_;
};

TEST(LevenbergMarquardt, ConvergesWhereRoundingHidesTheRestOfTheDecrease) {
  RoundedProblem strict, rounded;
  EXPECT_EQ(levenberg_marquardt(strict, {.step_tolerance = 0}).stop, Stop::no_decrease);
  EXPECT_EQ(levenberg_marquardt(rounded, {.step_tolerance = 0, .rounding_tolerance = 1e-12}).stop,
            Stop::rounding_limit);
  RoundedProblem far;
  EXPECT_EQ(levenberg_marquardt(far, {.max_steps = 1, .rounding_tolerance = 1e-12}).stop, Stop::max_steps);
  RoundedProblem near;
  EXPECT_EQ(levenberg_marquardt(near, {.max_steps = 12, .rounding_tolerance = 1e-12}).stop, Stop::rounding_limit);
}

// r = ln x − 1 vanishes at e. From x = 100 the undamped step leads to x < 0, where the logarithm does not exist.
TEST(LevenbergMarquardt, StaysInsideTheLimits) {
  VectorXd x = vector({100});
  const auto residual = [](const VectorXd& p) -> std::optional<VectorXd> {
    if (!(p[0] > 0)) return std::nullopt;
    return vector({std::log(p[0]) - 1});
  };
  const auto jacobian = [](const VectorXd& p) { return MatrixXd(MatrixXd::Constant(1, 1, 1 / p[0])); };
  EXPECT_TRUE(levenberg_marquardt(x, residual, jacobian).converged());
  EXPECT_NEAR(x[0], std::exp(1.0), 10 * kRounding);
  VectorXd outside = vector({-1});
  EXPECT_THROW(levenberg_marquardt(outside, residual, jacobian), std::invalid_argument);
}

// r = arctan x: the undamped step from x = 3 overshoots to −9.5, and each further step goes farther.
TEST(LevenbergMarquardt, NeverRaisesTheCost) {
  VectorXd x = vector({3});
  double lowest = std::numeric_limits<double>::infinity();
  const auto summary = levenberg_marquardt(
      x, [](const VectorXd& p) { return vector({std::atan(p[0])}); },
      [&](const VectorXd& p) {
        EXPECT_LE(std::abs(std::atan(p[0])), lowest);
        lowest = std::abs(std::atan(p[0]));
        return MatrixXd(MatrixXd::Constant(1, 1, 1 / (1 + p[0] * p[0])));
      });
  EXPECT_TRUE(summary.converged());
  EXPECT_GT(summary.trials, summary.steps);
  EXPECT_NEAR(x[0], 0, kRounding);
}

// r = x²: each Gauss–Newton step halves x.
TEST(LevenbergMarquardt, StopsForTheReasonThatItStates) {
  const auto residual = [](const VectorXd& p) { return vector({p[0] * p[0]}); };
  const auto jacobian = [](const VectorXd& p) { return MatrixXd(MatrixXd::Constant(1, 1, 2 * p[0])); };
  VectorXd x = vector({1});
  EXPECT_EQ(levenberg_marquardt(x, residual, jacobian, {.max_steps = 3}).stop, Stop::max_steps);
  EXPECT_NEAR(x[0], 0.125, 1e-3);  // three steps, the first with a damping of 1e-3
  EXPECT_EQ(levenberg_marquardt(x, residual, jacobian, {.step_tolerance = 1e-3}).stop, Stop::small_step);
  // The expected decrease, r·J(JᵀJ)⁻¹Jᵀr, is the whole cost.
  EXPECT_EQ(levenberg_marquardt(x, residual, jacobian, {.cost_tolerance = 1.1}).stop, Stop::small_decrease);
  // A Jacobian of the wrong sign leads uphill.
  const auto uphill = [&](const VectorXd& p) { return MatrixXd(-jacobian(p)); };
  x[0] = 1;
  EXPECT_EQ(levenberg_marquardt(x, residual, uphill, {.max_rejections = 5}).stop, Stop::no_decrease);
  EXPECT_EQ(levenberg_marquardt(x, residual, uphill, {.max_damping = 1e6}).stop, Stop::no_decrease);
  EXPECT_EQ(levenberg_marquardt(x, residual, uphill, {.step_tolerance = 1e-4}).stop, Stop::rounding_limit);
  EXPECT_EQ(x[0], 1);
}

// Misra1a: y = b1 (1 − exp(−b2 x)).
const std::vector<double> kMisraX{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                  378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
const std::vector<double> kMisraY{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                  44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

VectorXd misra_residual(const VectorXd& b) {
  return (b[0] * (1 - (-b[1] * vector(kMisraX).array()).exp()) - vector(kMisraY).array()).matrix();
}
MatrixXd misra_jacobian(const VectorXd& b) {
  const Eigen::ArrayXd x = vector(kMisraX).array(), decay = (-b[1] * x).exp();
  MatrixXd j(x.size(), 2);
  j.col(0) = 1 - decay;
  j.col(1) = b[0] * x * decay;
  return j;
}

// Thurber: y = (b1 + b2 x + b3 x² + b4 x³)/(1 + b5 x + b6 x² + b7 x³).
const std::vector<double> kThurberX{-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481,
                                    -2.363, -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714,
                                    -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010,  0.119,  0.377,  0.790,
                                    0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200};
const std::vector<double> kThurberY{80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,
                                    92.405,   95.854,   100.696,  101.060,  401.672,  390.724,  567.534,  635.316,
                                    733.054,  759.087,  894.206,  990.785,  1090.109, 1080.914, 1122.643, 1178.351,
                                    1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384,
                                    1442.962, 1464.350, 1468.705, 1447.894, 1457.628};

MatrixXd powers(const VectorXd& x) {
  MatrixXd out(x.size(), 4);
  for (Index k = 0; k < 4; ++k) out.col(k) = x.array().pow(static_cast<double>(k));
  return out;
}
VectorXd thurber_residual(const VectorXd& b) {
  const MatrixXd x = powers(vector(kThurberX));
  const Eigen::ArrayXd above = x * b.head(4), below = 1 + (x.rightCols(3) * b.tail(3)).array();
  return (above / below - vector(kThurberY).array()).matrix();
}
MatrixXd thurber_jacobian(const VectorXd& b) {
  const MatrixXd x = powers(vector(kThurberX));
  const Eigen::ArrayXd above = x * b.head(4), below = 1 + (x.rightCols(3) * b.tail(3)).array();
  MatrixXd j(x.rows(), 7);
  j.leftCols(4) = x.array().colwise() / below;
  j.rightCols(3) = -(x.rightCols(3).array().colwise() * (above / below.square()));
  return j;
}

struct Certified {
  ResidualFunction residual;
  JacobianFunction jacobian;
  std::vector<std::vector<double>> starts;
  std::vector<double> parameters, standard_deviations;
  double sum_of_squares;
};

void expect_certified(const Certified& set) {
  for (const auto& start : set.starts) {
    VectorXd b = vector(start);
    EXPECT_TRUE(levenberg_marquardt(b, set.residual, set.jacobian).converged());
    const double sum = set.residual(b)->squaredNorm();
    EXPECT_NEAR(sum / set.sum_of_squares, 1, kCertified);
    const MatrixXd j = set.jacobian(b);
    const MatrixXd covariance =
        inverse_gram(MatrixXd(j.transpose() * j)) * sum / static_cast<double>(j.rows() - j.cols());
    for (Index i = 0; i < b.size(); ++i) {
      const double standard_deviation = set.standard_deviations[static_cast<std::size_t>(i)];
      EXPECT_NEAR(b[i], set.parameters[static_cast<std::size_t>(i)], kCostRounding * standard_deviation);
      EXPECT_NEAR(std::sqrt(covariance(i, i)) / standard_deviation, 1, kStdTolerance);
    }
  }
}

// The certified values of two of NIST's reference data sets, from both starts: source [21] in
// docs/theory/sources.md.
TEST(LevenbergMarquardt, FindsTheCertifiedValuesOfMisra1a) {
  expect_certified({.residual = misra_residual,
                    .jacobian = misra_jacobian,
                    .starts = {{500, 0.0001}, {250, 0.0005}},
                    .parameters = {2.3894212918E+02, 5.5015643181E-04},
                    .standard_deviations = {2.7070075241E+00, 7.2668688436E-06},
                    .sum_of_squares = 1.2455138894E-01});
}

TEST(LevenbergMarquardt, FindsTheCertifiedValuesOfThurber) {
  expect_certified({.residual = thurber_residual,
                    .jacobian = thurber_jacobian,
                    .starts = {{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, {1300, 1500, 500, 75, 1, 0.4, 0.05}},
                    .parameters = {1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01,
                                   9.6629502864E-01, 3.9797285797E-01, 4.9727297349E-02},
                    .standard_deviations = {4.6647963344E+00, 3.9571156086E+01, 2.8698696102E+01, 5.5675370270E+00,
                                            3.1333340687E-02, 1.4984928198E-02, 6.5842344623E-03},
                    .sum_of_squares = 5.6427082397E+03});
}

// Parameters in other units, by powers of two: the same steps, to the last bit.
TEST(LevenbergMarquardt, DoesNotDependOnTheUnits) {
  constexpr double kUnit0 = 1024, kUnit1 = 1.0 / 4096;
  VectorXd b = vector({500, 0.0001}), scaled = vector({500 / kUnit0, 0.0001 / kUnit1});
  const auto in_units = [&](const VectorXd& p) { return vector({p[0] * kUnit0, p[1] * kUnit1}); };
  const auto plain = levenberg_marquardt(b, misra_residual, misra_jacobian, {.step_tolerance = 0});
  const auto other = levenberg_marquardt(
      scaled, [&](const VectorXd& p) { return misra_residual(in_units(p)); },
      [&](const VectorXd& p) {
        MatrixXd j = misra_jacobian(in_units(p));
        j.col(0) *= kUnit0;
        j.col(1) *= kUnit1;
        return j;
      },
      {.step_tolerance = 0});
  EXPECT_EQ(in_units(scaled), b);
  EXPECT_EQ(plain.trials, other.trials);
}

}  // namespace percuss::levenberg_marquardt_test
