#include "core/math/levenberg_marquardt.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/budget.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss {
inline namespace core {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Stop = LevenbergMarquardtStop;

class DenseProblem : public LeastSquaresProblem {
 public:
  DenseProblem(VectorXd& parameters, const ResidualFunction& residual, const JacobianFunction& jacobian)
      : parameters_(parameters), residual_function_(residual), jacobian_(jacobian) {
    std::optional<VectorXd> start = residual(parameters);
    if (!start) throw std::invalid_argument("Levenberg-Marquardt starts outside the parameters' limits");
    residual_ = *std::move(start);
    cost_ = residual_.squaredNorm();
  }

  double cost() const override { return cost_; }
  const NormalEquations& normal_equations() override {
    const MatrixXd j = jacobian_(parameters_);
    normal_ = {.matrix = j.transpose() * j, .right = -(j.transpose() * residual_)};
    return normal_;
  }
  std::optional<double> try_step(const VectorXd& step) override {
    trial_ = parameters_ + step;
    std::optional<VectorXd> residual = residual_function_(trial_);
    if (!residual) return std::nullopt;
    trial_residual_ = *std::move(residual);
    trial_cost_ = trial_residual_.squaredNorm();
    return trial_cost_;
  }
  void accept() override {
    parameters_.swap(trial_);
    residual_.swap(trial_residual_);
    cost_ = trial_cost_;
  }

 private:
  VectorXd& parameters_;
  const ResidualFunction& residual_function_;
  const JacobianFunction& jacobian_;
  VectorXd residual_, trial_, trial_residual_;
  double cost_ = 0, trial_cost_ = 0;
  NormalEquations normal_;
};

class Search {
 public:
  Search(LeastSquaresProblem& problem, const LevenbergMarquardtOptions& options)
      : problem_(problem), options_(options), damping_(options.initial_damping) {}

  LevenbergMarquardtSummary run() {
    while (summary_.steps < options_.max_steps) {
      if (const std::optional<Stop> stop = next_step()) {
        summary_.stop = *stop;
        return summary_;
      }
    }
    summary_.stop = is_at_rounding_limit() ? Stop::rounding_limit : Stop::max_steps;
    return summary_;
  }

 private:
  // Raises the damping until a trial lowers the cost. Returns the reason to stop, if there is one.
  std::optional<Stop> next_step() {
    const NormalEquations& normal = problem_.normal_equations();
    for (int rejections = 0; rejections < options_.max_rejections && damping_ <= options_.max_damping; ++rejections) {
      const VectorXd step = solve_gram(normal.matrix, normal.right, damping_);
      if (expects_small_decrease(normal, step)) return Stop::small_decrease;
      const double size = problem_.step_size(step);
      const std::optional<double> cost = cost_after(step, size);
      if (!cost) {
        damping_ = std::max(damping_ * options_.damping_increase, options_.min_damping_outside);
        continue;
      }
      const bool lower = *cost <= problem_.cost();
      if (lower) {
        const bool is_small = problem_.cost() - *cost < options_.cost_tolerance * problem_.cost();
        small_decreases_ = is_small ? small_decreases_ + 1 : 0;
        problem_.accept();
        ++summary_.steps;
      }
      if (size < options_.step_tolerance) return lower ? Stop::small_step : Stop::rounding_limit;
      damping_ *= lower ? options_.damping_decrease : options_.damping_increase;
      if (lower && options_.max_small_decreases > 0 && small_decreases_ >= options_.max_small_decreases)
        return Stop::small_decrease;
      if (lower) return std::nullopt;
    }
    return is_at_rounding_limit() ? Stop::rounding_limit : Stop::no_decrease;
  }

  bool is_at_rounding_limit() {
    if (options_.rounding_tolerance <= 0) return false;
    const NormalEquations& normal = problem_.normal_equations();
    const VectorXd step = solve_gram(normal.matrix, normal.right, options_.initial_damping);
    return step.dot(normal.right) < options_.rounding_tolerance * problem_.cost();
  }

  // While the damping has not risen above its start, step·right is close to the decrease of the cost.
  bool expects_small_decrease(const NormalEquations& normal, const VectorXd& step) const {
    return options_.cost_tolerance > 0 && damping_ <= options_.initial_damping &&
           step.dot(normal.right) < options_.cost_tolerance * problem_.cost();
  }

  std::optional<double> cost_after(const VectorXd& step, double size) {
    if (!std::isfinite(size) || size > options_.max_step_size) return std::nullopt;
    ++summary_.trials;
    check_budget();
    return problem_.try_step(step);
  }

  LeastSquaresProblem& problem_;
  const LevenbergMarquardtOptions& options_;
  double damping_;
  int small_decreases_ = 0;  // in a row
  LevenbergMarquardtSummary summary_;
};

}  // namespace

LevenbergMarquardtSummary levenberg_marquardt(LeastSquaresProblem& problem, const LevenbergMarquardtOptions& options) {
  return Search(problem, options).run();
}

LevenbergMarquardtSummary levenberg_marquardt(VectorXd& parameters, const ResidualFunction& residual,
                                              const JacobianFunction& jacobian,
                                              const LevenbergMarquardtOptions& options) {
  DenseProblem problem(parameters, residual, jacobian);
  return levenberg_marquardt(problem, options);
}

}  // namespace core
}  // namespace percuss
