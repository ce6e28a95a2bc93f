#include "model/trampoline/trampoline_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss::model {
namespace {

constexpr double kExponentDifference = 1e-4;  // of an exponent, for central differences: the model's error is 1e-11
constexpr double kMaxExponentStd = 100;       // a larger one comes from rounding: the exponent is not determined
constexpr LevenbergMarquardtOptions kExponentFitOptions{.max_damping = 1e12, .step_tolerance = 1e-9};
constexpr const char* kMeasuredCcor = "the measured CCOR";

// Exponents are [a, b].
bool is_usable(const Eigen::VectorXd& e) { return e[0] > -1 && e[1] >= 0 && e[1] < 1 + e[0]; }

class CcorFit {
 public:
  CcorFit(const Trampoline& model, const std::vector<MeasuredCor>& measured) : model_(model), measured_(measured) {}

  double cor(const Eigen::VectorXd& e, double speed_mps) const {
    Trampoline model = model_;
    model.stiffness_exponent = e[0];
    model.damping_exponent = e[1];
    model.ball_speed_mps = speed_mps;
    return rigid_wall_rebound(model).cor;
  }

  // (cor − model)/σ
  Eigen::VectorXd residual(const Eigen::VectorXd& e) const {
    Eigen::VectorXd out(std::ssize(measured_));
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const MeasuredCor& m = measured_[static_cast<std::size_t>(i)];
      out[i] = (m.cor - cor(e, m.speed_mps)) / m.cor_std;
    }
    return out;
  }

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& e) const {
    Eigen::MatrixXd out(std::ssize(measured_), 2);
    for (Eigen::Index k = 0; k < 2; ++k) {
      Eigen::VectorXd up = e, down = e;
      up[k] += kExponentDifference;
      down[k] -= kExponentDifference;
      out.col(k) = (residual(up) - residual(down)) / (2 * kExponentDifference);
    }
    return out;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd exponents{{model_.stiffness_exponent, model_.damping_exponent}};
    const auto if_usable = [&](const Eigen::VectorXd& at) {
      return is_usable(at) ? std::optional(residual(at)) : std::nullopt;
    };
    const auto jacobian_at = [&](const Eigen::VectorXd& at) { return jacobian(at); };
    const auto summary = levenberg_marquardt(exponents, if_usable, jacobian_at, kExponentFitOptions);
    if (summary.stop == LevenbergMarquardtStop::max_steps) {
      throw InputError("no exponents a and b fit the speeds", kMeasuredCcor,
                       "check the speeds, or start from other exponents", {"fit_ccor", "a", "b"});
    }
    return exponents;
  }

 private:
  Trampoline model_;
  const std::vector<MeasuredCor>& measured_;
};

}  // namespace

ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured) {
  std::set<double> speeds;
  for (const MeasuredCor& m : measured) speeds.insert(m.speed_mps);
  if (speeds.size() < 2)
    throw InputError("a and b need two different speeds", kMeasuredCcor, "measure at more speeds", {"fit_ccor"});
  const CcorFit fit(model, measured);
  const Eigen::VectorXd best = fit.solve();
  const Eigen::MatrixXd j = fit.jacobian(best);
  const Eigen::MatrixXd covariance = inverse_gram(Eigen::MatrixXd(j.transpose() * j));
  ExponentFit result{.stiffness_exponent = best[0],
                     .stiffness_exponent_std = std::sqrt(covariance(0, 0)),
                     .damping_exponent = best[1],
                     .damping_exponent_std = std::sqrt(covariance(1, 1))};
  if (!(std::max(result.stiffness_exponent_std, result.damping_exponent_std) < kMaxExponentStd)) {
    throw InputError("the speeds are too similar to separate a from b", kMeasuredCcor, "measure at more speeds",
                     {"fit_ccor"});
  }
  result.correlation = covariance(0, 1) / (result.stiffness_exponent_std * result.damping_exponent_std);
  result.damping_exponent_std_given_a = 1 / j.col(1).norm();
  const Eigen::VectorXd residual = fit.residual(best);
  result.chi2 = residual.squaredNorm();
  result.beyond_std = static_cast<std::size_t>((residual.array().abs() > 1).count());
  result.model_cor.reserve(measured.size());
  for (const MeasuredCor& m : measured) result.model_cor.push_back(fit.cor(best, m.speed_mps));
  return result;
}

}  // namespace percuss::model
