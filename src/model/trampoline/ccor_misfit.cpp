#include "model/trampoline/ccor_misfit.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math/levenberg_marquardt.hpp"
#include "core/math/roots.hpp"

namespace percuss::model {
namespace {

constexpr double kExponentDifference = 1e-4;  // of an exponent, for central differences: the model's error is 1e-10
constexpr double kReleaseMargin = 1e-6;       // of b below 1 + a, where the dashpot still releases the ball
constexpr LevenbergMarquardtOptions kExponentFitOptions{.max_damping = 1e12, .step_tolerance = 1e-9};

}  // namespace

Trampoline with_exponents(Trampoline model, const Exponents& e) {
  model.stiffness_exponent = e[0];
  model.damping_exponent = e[1];
  return model;
}

bool CcorMisfit::is_usable(const Exponents& e) {
  return e[0] >= 0 && e[0] <= kMaxStiffnessExponent && e[1] >= 0 && e[1] < 1 + e[0];
}

double CcorMisfit::cor(const Exponents& e, double speed_mps) const {
  Trampoline model = with_exponents(model_, e);
  model.ball_speed_mps = speed_mps;
  return rigid_wall_rebound(model).cor;
}

Eigen::VectorXd CcorMisfit::residual(const Exponents& e) const {
  Eigen::VectorXd out(std::ssize(measured_));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const MeasuredCor& m = measured_[static_cast<std::size_t>(i)];
    out[i] = (m.cor - cor(e, m.speed_mps)) / m.cor_std;
  }
  return out;
}

Eigen::MatrixXd CcorMisfit::jacobian(const Exponents& e) const {
  Eigen::MatrixXd out(std::ssize(measured_), 2);
  for (Eigen::Index k = 0; k < 2; ++k) {
    Exponents up = e, down = e;
    up[k] += kExponentDifference;
    down[k] -= kExponentDifference;
    out.col(k) = (residual(up) - residual(down)) / (2 * kExponentDifference);
  }
  return out;
}

Exponents CcorMisfit::minimum(const Exponents& start, const std::array<bool, 2>& free) const {
  std::vector<Eigen::Index> index;
  for (const int k : {0, 1}) {
    if (free.at(static_cast<std::size_t>(k))) index.push_back(k);
  }
  if (index.empty()) return start;
  const auto exponents_at = [&](const Eigen::VectorXd& p) {
    Exponents e = start;
    for (std::size_t i = 0; i < index.size(); ++i) e[index[i]] = p[static_cast<Eigen::Index>(i)];
    return e;
  };
  Eigen::VectorXd parameters(std::ssize(index));
  for (std::size_t i = 0; i < index.size(); ++i) parameters[static_cast<Eigen::Index>(i)] = start[index[i]];
  const auto if_usable = [&](const Eigen::VectorXd& p) {
    const Exponents e = exponents_at(p);
    return is_usable(e) ? std::optional(residual(e)) : std::nullopt;
  };
  const auto jacobian_at = [&](const Eigen::VectorXd& p) {
    const Eigen::MatrixXd both = jacobian(exponents_at(p));
    Eigen::MatrixXd out(both.rows(), std::ssize(index));
    for (std::size_t i = 0; i < index.size(); ++i) out.col(static_cast<Eigen::Index>(i)) = both.col(index[i]);
    return out;
  };
  const auto summary = levenberg_marquardt(parameters, if_usable, jacobian_at, kExponentFitOptions);
  if (summary.stop == LevenbergMarquardtStop::max_steps) {
    throw InputError("no exponents a and b fit the speeds", "the measured CCOR",
                     "check the speeds, or hold an exponent", {"fit_ccor", "hold"});
  }
  return exponents_at(parameters);
}

Exponents CcorMisfit::best_with_a(double a, const Exponents& near) const {
  return minimum({a, std::min(near[1], (1 - kStartMargin) * (1 + a))}, {false, true});
}

std::optional<std::array<double, 2>> CcorMisfit::range_within_std(const Exponents& at, int varied) const {
  const double end = varied == 0 ? kMaxStiffnessExponent : 1 + at[0] - kReleaseMargin;
  const double start = varied == 0 ? std::max(0.0, at[1] - 1 + kReleaseMargin) : 0;
  std::array<double, 2> range{start, end};
  for (const MeasuredCor& m : measured_) {
    const auto misfit_of = [&](double target) {
      return [&, target](double value) {
        Exponents e = at;
        e[varied] = value;
        return cor(e, m.speed_mps) - target;
      };
    };
    // The COR rises with b and falls with a, both monotonically: each limit is a single root, or lies outside.
    const bool rises = misfit_of(0)(end) > misfit_of(0)(start);
    const auto limit = [&](double target) {
      const auto misfit = misfit_of(target);
      const double first = misfit(start), last = misfit(end);
      if (first * last < 0) return bracketed_root(misfit, start, end);
      return (first > 0) == rises ? start : end;
    };
    const double low = limit(m.cor - (rises ? m.cor_std : -m.cor_std));
    const double high = limit(m.cor + (rises ? m.cor_std : -m.cor_std));
    range = {std::max(range[0], low), std::min(range[1], high)};
  }
  if (!(range[0] < range[1])) return std::nullopt;
  return range;
}

}  // namespace percuss::model
