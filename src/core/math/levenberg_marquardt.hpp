#pragma once
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>

namespace percuss {
inline namespace core {

/// matrix·step = right: matrix = JᵀJ and right = −Jᵀr for a residual r with the Jacobian J = ∂r/∂x.
/// shapes: matrix [n, n], right [n].
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

/// A sum of squares to minimise. The object holds the current point and the trial point.
class LeastSquaresProblem {
 public:
  virtual ~LeastSquaresProblem() = default;

  /// The sum of squares at the current point.
  virtual double cost() const = 0;
  /// The normal equations at the current point, valid until accept(). The search asks for them once per accepted step,
  /// and perhaps once more at its end.
  virtual const NormalEquations& normal_equations() = 0;
  /// The size of a step in the unit of LevenbergMarquardtOptions::step_tolerance; the Euclidean norm unless overridden.
  virtual double step_size(const Eigen::VectorXd& step) const { return step.norm(); }
  /// The cost at the trial point "current point + step"; none where that point lies outside the problem's limits.
  virtual std::optional<double> try_step(const Eigen::VectorXd& step) = 0;
  /// Makes the last trial point the current point.
  virtual void accept() = 0;
};

struct LevenbergMarquardtOptions {
  int max_steps = 100;             // accepted steps
  int max_rejections = 50;         // trials in a row that do not lower the cost
  double initial_damping = 1e-3;   // relative to each diagonal element of the matrix
  double damping_decrease = 0.1;   // factor after an accepted step
  double damping_increase = 10;    // factor after a rejected one
  double min_damping_outside = 0;  // the damping after a trial outside the limits is at least this
  double max_damping = std::numeric_limits<double>::infinity();    // the search stops above it
  double max_step_size = std::numeric_limits<double>::infinity();  // a larger step counts as outside the limits
  double step_tolerance = 1e-12;                                   // a step below this size ends the search
  // While the damping is at most initial_damping, an expected decrease below this fraction of the cost ends the search.
  double cost_tolerance = 0;
  // The search ends after this many steps in a row that each lower the cost by less than cost_tolerance; 0: never.
  int max_small_decreases = 0;
  // If no trial lowers the cost, or after max_steps, an expected decrease below this fraction of the cost is taken as
  // rounding, and the search as converged. Unknowns that the data hardly determine may never reach step_tolerance.
  double rounding_tolerance = 0;
};

/// Why the search ended.
enum class LevenbergMarquardtStop {
  small_step,      // an accepted step was smaller than step_tolerance
  rounding_limit,  // a step below step_tolerance, or with a decrease below rounding_tolerance, did not lower the cost
  small_decrease,  // the decrease of the cost, expected or in several steps, was below cost_tolerance
  no_decrease,     // max_rejections or max_damping was reached
  max_steps,
};

struct LevenbergMarquardtSummary {
  LevenbergMarquardtStop stop = LevenbergMarquardtStop::max_steps;
  int steps = 0;   // accepted
  int trials = 0;  // points at which the cost was asked for

  /// The current point is a minimum to within the tolerances.
  bool converged() const {
    return stop != LevenbergMarquardtStop::no_decrease && stop != LevenbergMarquardtStop::max_steps;
  }
};

/// Minimises a sum of squares from the problem's current point by damped Gauss–Newton steps (Levenberg, Marquardt). The
/// damping is relative to the matrix's diagonal, so that the unknowns' units do not matter. The cost never rises.
/// theory (4.10)
LevenbergMarquardtSummary levenberg_marquardt(LeastSquaresProblem& problem,
                                              const LevenbergMarquardtOptions& options = {});

/// A residual as a function of its parameters, [m] of [n]; none outside the limits of the parameters.
using ResidualFunction = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& parameters)>;
/// Its Jacobian, [m, n].
using JacobianFunction = std::function<Eigen::MatrixXd(const Eigen::VectorXd& parameters)>;

/// The same for a small dense problem: minimises |residual|² over `parameters` [n], which hold the start and then the
/// result. errors  std::invalid_argument: the start lies outside the limits.
LevenbergMarquardtSummary levenberg_marquardt(Eigen::VectorXd& parameters, const ResidualFunction& residual,
                                              const JacobianFunction& jacobian,
                                              const LevenbergMarquardtOptions& options = {});

}  // namespace core
}  // namespace percuss
