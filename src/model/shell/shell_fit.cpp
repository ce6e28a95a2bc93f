#include "model/shell/shell_fit.hpp"

#include <Eigen/Core>
#include <cmath>

#include "core/error.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss::model {
namespace {

constexpr double kShellNudge = 1e-6;  // of ln E or ln h, for differences
constexpr double kShellSettled = 1e-12;
constexpr double kToldApart = 0.5;  // the largest deviation of ln E or ln h that still says something
constexpr double kMaxShellDamping = 1e12;
constexpr int kMaxShellSteps = 100;
constexpr const char* kHoops = "the measured hoop frequencies";
constexpr const char* kHoopRemedy = "fit only E or only the wall, or add patterns with other n and m";

class HoopFit {
 public:
  HoopFit(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns)
      : start_(shell), measured_(measured), unknowns_(unknowns) {}

  Eigen::Index count() const { return unknowns_ == ShellUnknowns::both ? 2 : 1; }

  // The shell after changes of the logarithms of what is unknown.
  TubeShell shell(const Eigen::VectorXd& x) const {
    TubeShell shell = start_;
    if (unknowns_ != ShellUnknowns::wall) shell.young_Pa *= std::exp(x[0]);
    if (unknowns_ != ShellUnknowns::young) shell.wall_m *= std::exp(x[x.size() - 1]);
    return shell;
  }

  bool is_usable(const Eigen::VectorXd& x) const {
    return x.allFinite() && shell(x).wall_m < start_.outer_diameter_m / 2 && shell(x).wall_m > 0;
  }

  Eigen::VectorXd misfit(const Eigen::VectorXd& x) const {
    const TubeShell now = shell(x);
    Eigen::VectorXd out(std::ssize(measured_));
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const MeasuredHoop& hoop = measured_[static_cast<std::size_t>(i)];
      out[i] = (hoop.freq_Hz - flugge_Hz(now, hoop.n, hoop.m)) / hoop.freq_std_Hz;
    }
    return out;
  }

  Eigen::MatrixXd slopes(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd out(std::ssize(measured_), count());
    for (Eigen::Index k = 0; k < count(); ++k) {
      Eigen::VectorXd up = x, down = x;
      up[k] += kShellNudge;
      down[k] -= kShellNudge;
      out.col(k) = (misfit(down) - misfit(up)) / (2 * kShellNudge);
    }
    return out;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd now = Eigen::VectorXd::Zero(count()), rest = misfit(now);
    double damping = 1e-3;
    for (int i = 0; i < kMaxShellSteps; ++i) {
      const Eigen::MatrixXd j = slopes(now);
      const Eigen::VectorXd step = solve_gram(j.transpose() * j, j.transpose() * rest, damping), next = now + step;
      const bool usable = is_usable(next);
      const Eigen::VectorXd left = usable ? misfit(next) : rest;
      if (usable && left.squaredNorm() <= rest.squaredNorm()) {
        now = next;
        rest = left;
        damping /= 10;
      } else {
        damping *= 10;
      }
      if (step.norm() < kShellSettled || damping > kMaxShellDamping) return now;
    }
    throw InputError("no shell explains them", kHoops, kHoopRemedy);
  }

 private:
  TubeShell start_;
  const std::vector<MeasuredHoop>& measured_;
  ShellUnknowns unknowns_;
};

}  // namespace

ShellFit fit_shell(const TubeShell& shell, const std::vector<MeasuredHoop>& measured, ShellUnknowns unknowns) {
  const HoopFit fit(shell, measured, unknowns);
  if (std::ssize(measured) < fit.count()) throw InputError("E and wall need two frequencies", kHoops, kHoopRemedy);
  const Eigen::VectorXd best = fit.solve();
  const Eigen::MatrixXd j = fit.slopes(best);
  const Eigen::MatrixXd covariance = inverse_gram(Eigen::MatrixXd(j.transpose() * j));
  const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
  if (!(deviation.maxCoeff() < kToldApart))
    throw InputError("E and wall cannot be told from each other by these patterns", kHoops, kHoopRemedy);
  ShellFit result{.shell = fit.shell(best), .model_Hz = {}};
  if (unknowns != ShellUnknowns::wall) result.young_std_Pa = deviation[0] * result.shell.young_Pa;
  if (unknowns != ShellUnknowns::young) result.wall_std_m = deviation[fit.count() - 1] * result.shell.wall_m;
  if (unknowns == ShellUnknowns::both) result.correlation = covariance(0, 1) / (deviation[0] * deviation[1]);
  result.chi2 = fit.misfit(best).squaredNorm();
  result.model_Hz.reserve(measured.size());
  for (const MeasuredHoop& hoop : measured) result.model_Hz.push_back(flugge_Hz(result.shell, hoop.n, hoop.m));
  return result;
}

}  // namespace percuss::model
