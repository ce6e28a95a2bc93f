#include "model/shell/shell_fit.hpp"

#include <Eigen/Core>
#include <cmath>

#include "core/error.hpp"
#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"

namespace percuss::model {
namespace {

constexpr double kShellDifference = 1e-6;  // of ln E or ln h, for central differences
constexpr double kMaxShellStd = 0.5;       // of ln E or ln h: a larger one means that they are not determined
constexpr LevenbergMarquardtOptions kShellFitOptions{.max_damping = 1e12, .step_tolerance = 1e-12};
constexpr const char* kHoops = "the measured hoop frequencies";
constexpr const char* kSeparateRemedy = "fit only E or only the wall, or add patterns with other n and m";

class HoopFit {
 public:
  HoopFit(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns)
      : start_(shell), measured_(measured), unknowns_(unknowns) {}

  Eigen::Index count() const { return unknowns_ == ShellUnknowns::both ? 2 : 1; }

  // The shell with changes x of the logarithms of the unknowns.
  TubeShell shell(const Eigen::VectorXd& x) const {
    TubeShell shell = start_;
    if (unknowns_ != ShellUnknowns::wall) shell.young_Pa *= std::exp(x[0]);
    if (unknowns_ != ShellUnknowns::young) shell.wall_m *= std::exp(x[x.size() - 1]);
    return shell;
  }

  bool is_usable(const Eigen::VectorXd& x) const {
    return x.allFinite() && shell(x).wall_m < start_.outer_diameter_m / 2 && shell(x).wall_m > 0;
  }

  Eigen::VectorXd residual(const Eigen::VectorXd& x) const {
    const TubeShell now = shell(x);
    Eigen::VectorXd out(std::ssize(measured_));
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const MeasuredHoop& hoop = measured_[static_cast<std::size_t>(i)];
      out[i] = (hoop.freq_Hz - flugge_Hz(now, hoop.n, hoop.m)) / hoop.freq_std_Hz;
    }
    return out;
  }

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd out(std::ssize(measured_), count());
    for (Eigen::Index k = 0; k < count(); ++k) {
      Eigen::VectorXd up = x, down = x;
      up[k] += kShellDifference;
      down[k] -= kShellDifference;
      out.col(k) = (residual(up) - residual(down)) / (2 * kShellDifference);
    }
    return out;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(count());
    const auto if_usable = [&](const Eigen::VectorXd& at) {
      return is_usable(at) ? std::optional(residual(at)) : std::nullopt;
    };
    const auto jacobian_at = [&](const Eigen::VectorXd& at) { return jacobian(at); };
    const auto summary = levenberg_marquardt(x, if_usable, jacobian_at, kShellFitOptions);
    if (summary.stop == LevenbergMarquardtStop::max_steps) {
      throw InputError("no shell fits the frequencies", kHoops,
                       unknowns_ == ShellUnknowns::both ? kSeparateRemedy
                                                        : "check the frequencies' n and m, and the size of the tube",
                       {"measured"});
    }
    return x;
  }

 private:
  TubeShell start_;
  const std::vector<MeasuredHoop>& measured_;
  ShellUnknowns unknowns_;
};

}  // namespace

ShellFit fit_shell(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns) {
  const HoopFit fit(shell, measured, unknowns);
  if (std::ssize(measured) < fit.count()) {
    if (unknowns == ShellUnknowns::both)
      throw InputError("E and wall need two frequencies", kHoops, kSeparateRemedy, {"fit", "measured"});
    throw InputError(unknowns == ShellUnknowns::young ? "E needs a frequency" : "the wall needs a frequency", kHoops,
                     "measure one hoop frequency or more", {"measured"});
  }
  const Eigen::VectorXd best = fit.solve();
  const Eigen::MatrixXd j = fit.jacobian(best);
  const Eigen::MatrixXd covariance = inverse_gram(Eigen::MatrixXd(j.transpose() * j));
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseSqrt();
  if (!(sigma.maxCoeff() < kMaxShellStd)) {
    if (unknowns == ShellUnknowns::both) {
      throw InputError("these patterns do not separate E from the wall", kHoops, kSeparateRemedy, {"fit", "measured"});
    }
    throw InputError("these frequencies are too uncertain for a fit", kHoops,
                     "add frequencies, or measure them more precisely", {"measured"});
  }
  ShellFit result{.shell = fit.shell(best), .model_Hz = {}};
  result.chi2 = fit.residual(best).squaredNorm();
  const double scale = birge_ratio(result.chi2, static_cast<double>(std::ssize(measured) - fit.count()));
  if (unknowns != ShellUnknowns::wall) result.young_std_Pa = scale * sigma[0] * result.shell.young_Pa;
  if (unknowns != ShellUnknowns::young) result.wall_std_m = scale * sigma[fit.count() - 1] * result.shell.wall_m;
  if (unknowns == ShellUnknowns::both) result.correlation = covariance(0, 1) / (sigma[0] * sigma[1]);
  result.model_Hz.reserve(measured.size());
  for (const MeasuredHoop& hoop : measured) result.model_Hz.push_back(flugge_Hz(result.shell, hoop.n, hoop.m));
  return result;
}

}  // namespace percuss::model
