#include "model/beam/beam_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss::model {
namespace {

constexpr double kMinTorsion = 1e-6, kMaxTorsion = 1e6;  // of T*: beyond, frequencies no longer tell
constexpr double kNearLimit = 10;
constexpr int kMaxFitRounds = 200;
constexpr double kFitSettled = 1e-12;    // of the parameters' logarithms
constexpr double kFitDifference = 1e-5;  // of a logarithm, for the derivatives: 1e-10 of them is left out

double& value_of(UniformBeam& beam, BeamParameter which) {
  return which == BeamParameter::stiffness ? beam.stiffness_Nm2
         : which == BeamParameter::torsion ? beam.torsion_Nmprad
                                           : beam.mass_per_length_kgpm;
}

class FrequencyFit {
 public:
  FrequencyFit(const UniformBeam& beam, const std::vector<BeamParameter>& asked,
               const std::vector<MeasuredFrequency>& measured)
      : start_(beam), asked_(asked), measured_(measured) {
    highest_ = 0;
    for (const MeasuredFrequency& one : measured) highest_ = std::max(highest_, one.mode);
    log_f_ = Eigen::VectorXd(rows());
    weight_ = Eigen::VectorXd(rows());
    for (Eigen::Index i = 0; i < rows(); ++i) {
      const MeasuredFrequency& one = measured[static_cast<std::size_t>(i)];
      log_f_(i) = std::log(one.freq_Hz);
      weight_(i) = one.std_Hz > 0 ? one.freq_Hz / one.std_Hz : 1;
    }
  }

  UniformBeam beam_at(const Eigen::VectorXd& logs) const {
    UniformBeam beam = start_;
    for (std::size_t i = 0; i < asked_.size(); ++i)
      value_of(beam, asked_[i]) = std::exp(logs(static_cast<Eigen::Index>(i)));
    return beam;
  }
  Eigen::VectorXd logs_of(UniformBeam beam) const {
    Eigen::VectorXd logs(static_cast<Eigen::Index>(asked_.size()));
    for (std::size_t i = 0; i < asked_.size(); ++i)
      logs(static_cast<Eigen::Index>(i)) = std::log(value_of(beam, asked_[i]));
    return logs;
  }

  Eigen::VectorXd model_logs(const UniformBeam& beam) const {
    const std::vector<BeamMode> modes = beam_modes(beam, highest_ + 1);
    Eigen::VectorXd logs(rows());
    for (Eigen::Index i = 0; i < rows(); ++i)
      logs(i) = std::log(modes[measured_[static_cast<std::size_t>(i)].mode].freq_Hz());
    return logs;
  }
  Eigen::VectorXd misfit(const Eigen::VectorXd& logs) const {
    return (log_f_ - model_logs(beam_at(logs))).cwiseProduct(weight_);
  }
  bool allowed(const Eigen::VectorXd& logs) const {
    if (!logs.allFinite()) return false;
    const double relative = beam_at(logs).relative_torsion();
    return start_.support != BeamSupport::torsion || (relative >= kMinTorsion && relative <= kMaxTorsion);
  }
  Eigen::MatrixXd derivatives(const Eigen::VectorXd& logs) const {
    Eigen::MatrixXd columns(rows(), logs.size());
    for (Eigen::Index i = 0; i < logs.size(); ++i) {
      const Eigen::VectorXd step = kFitDifference * Eigen::VectorXd::Unit(logs.size(), i);
      columns.col(i) = (misfit(logs - step) - misfit(logs + step)) / (2 * kFitDifference);
    }
    return columns;
  }

  // Over the range of T* the beam that fits best, as far as the parameters asked for leave it free.
  Eigen::VectorXd best_start() const {
    Eigen::VectorXd best = logs_of(start_);
    double least = std::numeric_limits<double>::infinity();
    constexpr int kPlaces = 61;
    for (int i = 0; i < kPlaces; ++i) {
      const double relative = std::pow(10, -5 + 10.0 * i / (kPlaces - 1));
      const Eigen::VectorXd logs = logs_of(scaled(with_torsion(relative)));
      if (!allowed(logs)) continue;
      const double chi2 = misfit(logs).squaredNorm();
      if (chi2 < least) {
        least = chi2;
        best = logs;
      }
    }
    return best;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd logs = best_start();
    double chi2 = misfit(logs).squaredNorm(), damping = 1e-3;
    for (int round = 0; round < kMaxFitRounds; ++round) {
      const Eigen::MatrixXd columns = derivatives(logs);
      const Eigen::VectorXd step =
          solve_gram(columns.transpose() * columns, columns.transpose() * misfit(logs), damping);
      if (!step.allFinite()) break;
      const Eigen::VectorXd next = logs + step;
      const double next_chi2 = allowed(next) ? misfit(next).squaredNorm() : std::numeric_limits<double>::infinity();
      if (next_chi2 <= chi2) {
        logs = next;
        chi2 = next_chi2;
        damping /= 10;
      } else {
        damping *= 10;
      }
      if (step.norm() <= kFitSettled || damping > 1e15) break;
    }
    return logs;
  }

 private:
  Eigen::Index rows() const { return static_cast<Eigen::Index>(measured_.size()); }
  bool fits(BeamParameter which) const { return std::find(asked_.begin(), asked_.end(), which) != asked_.end(); }

  UniformBeam with_torsion(double relative) const {
    UniformBeam beam = start_;
    if (beam.support != BeamSupport::torsion) return beam;
    if (fits(BeamParameter::torsion)) {
      beam.torsion_Nmprad = relative * beam.stiffness_Nm2 / beam.length_m;
    } else if (fits(BeamParameter::stiffness)) {
      beam.stiffness_Nm2 = beam.torsion_Nmprad * beam.length_m / relative;
    }
    return beam;
  }
  // EI/ρA moved to where the frequencies fit on the whole, at the same T*.
  UniformBeam scaled(UniformBeam beam) const {
    const double squares = weight_.squaredNorm();
    const double factor = std::exp(2 * (log_f_ - model_logs(beam)).cwiseProduct(weight_.cwiseAbs2()).sum() / squares);
    const bool spring = start_.support == BeamSupport::torsion;
    if (fits(BeamParameter::mass_per_length)) {
      beam.mass_per_length_kgpm /= factor;
    } else if (fits(BeamParameter::stiffness) && (!spring || fits(BeamParameter::torsion))) {
      beam.stiffness_Nm2 *= factor;
      beam.torsion_Nmprad *= factor;
    }
    return beam;
  }

  UniformBeam start_;
  const std::vector<BeamParameter>& asked_;
  const std::vector<MeasuredFrequency>& measured_;
  std::size_t highest_;
  Eigen::VectorXd log_f_, weight_;
};

}  // namespace

std::size_t max_beam_parameters(BeamSupport support) { return support == BeamSupport::torsion ? 2 : 1; }

BeamFit fit_beam(const UniformBeam& beam, const std::vector<BeamParameter>& asked,
                 const std::vector<MeasuredFrequency>& measured) {
  assert(!asked.empty() && asked.size() <= max_beam_parameters(beam.support) && measured.size() >= asked.size());
  const FrequencyFit problem(beam, asked, measured);
  const Eigen::VectorXd logs = problem.solve();
  BeamFit fit{.beam = problem.beam_at(logs), .chi2 = problem.misfit(logs).squaredNorm()};
  const double relative = fit.beam.relative_torsion();
  fit.at_limit = beam.support == BeamSupport::torsion &&
                 (relative < kNearLimit * kMinTorsion || relative > kMaxTorsion / kNearLimit);
  const Eigen::VectorXd model = problem.model_logs(fit.beam).array().exp();
  fit.model_Hz.assign(model.begin(), model.end());
  const Eigen::MatrixXd columns = problem.derivatives(logs);
  const Eigen::MatrixXd gram = columns.transpose() * columns;
  const Eigen::MatrixXd covariance = inverse_gram(gram);
  const bool known = std::all_of(measured.begin(), measured.end(), [](const auto& one) { return one.std_Hz > 0; });
  const std::size_t spare = measured.size() - asked.size();
  const double variance = known ? 1 : spare > 0 ? fit.chi2 / static_cast<double>(spare) : 0;
  fit.parameters.reserve(asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    FittedParameter parameter{.which = asked[i], .value = value_of(fit.beam, asked[i])};
    const double std = parameter.value * std::sqrt(variance * covariance(at, at));
    if ((known || spare > 0) && std::isfinite(std)) parameter.std = std;
    fit.parameters.push_back(parameter);
  }
  return fit;
}

TorsionFit fit_torsion(const std::vector<StaticReading>& readings, double stiffness_Nm2) {
  assert(!readings.empty());
  double xx = 0, xy = 0;
  const auto turn = [](const StaticReading& r) { return r.load_N * r.lever_m * r.lever_m; };
  const auto turned_m = [&](const StaticReading& r) {
    return r.deflection_m - turn(r) * r.lever_m / (3 * stiffness_Nm2);  // (1)
  };
  for (const StaticReading& reading : readings) {
    xx += turn(reading) * turn(reading);
    xy += turn(reading) * turned_m(reading);
  }
  const double shear_parameter = xy / xx;  // 1/T
  if (!(shear_parameter > 0 && std::isfinite(shear_parameter))) {
    throw InputError("the beam's own bending would already deflect more than was read", "static readings",
                     "look at --ei and at the readings (--static) and their units: N, m, m");
  }
  TorsionFit fit{.torsion_Nmprad = 1 / shear_parameter};
  if (readings.size() < 2) return fit;
  double left = 0;
  for (const StaticReading& reading : readings)
    left += std::pow(turned_m(reading) - shear_parameter * turn(reading), 2);
  const double variance = left / static_cast<double>(readings.size() - 1) / xx;
  fit.std_Nmprad = std::sqrt(variance) / (shear_parameter * shear_parameter);
  return fit;
}

}  // namespace percuss::model
