#include "model/trampoline/trampoline_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss::model {
namespace {

constexpr double kExponentNudge = 1e-4;  // of an exponent: differences of a model that is good to 1e-11
constexpr double kExponentsSettled = 1e-9;
constexpr double kMaxFitDamping = 1e12;
constexpr double kUnknownExponent = 100;  // a deviation as large is rounding's
constexpr int kMaxFitSteps = 100;
constexpr const char* kMeasuredCcor = "the measured CCOR";

using Exponents = Eigen::Vector2d;  // a, b

bool is_usable(const Exponents& e) { return e[0] > -1 && e[1] >= 0 && e[1] < 1 + e[0]; }

class CcorFit {
 public:
  CcorFit(const Trampoline& model, const std::vector<MeasuredCor>& measured) : model_(model), measured_(measured) {}

  double cor(const Exponents& e, double speed_mps) const {
    Trampoline model = model_;
    model.stiffness_exponent = e[0];
    model.damping_exponent = e[1];
    model.ball_speed_mps = speed_mps;
    return rigid_wall_rebound(model).cor;
  }

  // (cor − model)/σ
  Eigen::VectorXd misfit(const Exponents& e) const {
    Eigen::VectorXd out(std::ssize(measured_));
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const MeasuredCor& m = measured_[static_cast<std::size_t>(i)];
      out[i] = (m.cor - cor(e, m.speed_mps)) / m.cor_std;
    }
    return out;
  }

  Eigen::MatrixXd slopes(const Exponents& e) const {
    Eigen::MatrixXd out(std::ssize(measured_), 2);
    for (Eigen::Index k = 0; k < 2; ++k) {
      Exponents up = e, down = e;
      up[k] += kExponentNudge;
      down[k] -= kExponentNudge;
      out.col(k) = (misfit(down) - misfit(up)) / (2 * kExponentNudge);
    }
    return out;
  }

  Exponents solve() const {
    Exponents now(model_.stiffness_exponent, model_.damping_exponent);
    Eigen::VectorXd rest = misfit(now);
    double damping = 1e-3;
    for (int i = 0; i < kMaxFitSteps; ++i) {
      const Eigen::MatrixXd j = slopes(now);
      const Exponents step = solve_gram(j.transpose() * j, j.transpose() * rest, damping);
      const Exponents next = now + step;
      const Eigen::VectorXd left = is_usable(next) ? misfit(next) : rest;
      if (is_usable(next) && left.squaredNorm() <= rest.squaredNorm()) {
        now = next;
        rest = left;
        damping /= 10;
      } else {
        damping *= 10;
      }
      if (step.norm() < kExponentsSettled || damping > kMaxFitDamping) return now;
    }
    throw InputError("no exponents a and b explain it", kMeasuredCcor, "check speeds, or start from other --a and --b");
  }

 private:
  Trampoline model_;
  const std::vector<MeasuredCor>& measured_;
};

}  // namespace

ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured) {
  std::set<double> speeds;
  for (const MeasuredCor& m : measured) speeds.insert(m.speed_mps);
  if (speeds.size() < 2) throw InputError("a and b need two different speeds", kMeasuredCcor, "measure at more speeds");
  const CcorFit fit(model, measured);
  const Exponents best = fit.solve();
  const Eigen::MatrixXd j = fit.slopes(best);
  const Eigen::MatrixXd covariance = inverse_gram(Eigen::MatrixXd(j.transpose() * j));
  ExponentFit result{.stiffness_exponent = best[0],
                     .stiffness_exponent_std = std::sqrt(covariance(0, 0)),
                     .damping_exponent = best[1],
                     .damping_exponent_std = std::sqrt(covariance(1, 1))};
  if (!(std::max(result.stiffness_exponent_std, result.damping_exponent_std) < kUnknownExponent))
    throw InputError("the speeds are too alike to tell a from b", kMeasuredCcor, "measure at more speeds");
  result.correlation = covariance(0, 1) / (result.stiffness_exponent_std * result.damping_exponent_std);
  result.damping_exponent_std_given_a = 1 / j.col(1).norm();
  const Eigen::VectorXd rest = fit.misfit(best);
  result.chi2 = rest.squaredNorm();
  result.beyond_std = static_cast<std::size_t>((rest.array().abs() > 1).count());
  result.model_cor.reserve(measured.size());
  for (const MeasuredCor& m : measured) result.model_cor.push_back(fit.cor(best, m.speed_mps));
  return result;
}

}  // namespace percuss::model
