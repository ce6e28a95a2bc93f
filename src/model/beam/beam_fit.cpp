#include "model/beam/beam_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"

namespace percuss::model {
namespace {

constexpr double kMinTorsion = 1e-6, kMaxTorsion = 1e6;  // of T*: beyond them frequencies do not depend on it
constexpr double kNearLimit = 10;                        // a fitted T* within this factor of a limit is not determined
constexpr LevenbergMarquardtOptions kBeamFitOptions{.max_steps = 200, .max_damping = 1e15, .step_tolerance = 1e-12};
constexpr double kFitDifference = 1e-5;  // of a logarithm, for central differences: their relative error is 1e-10

double& value_of(UniformBeam& beam, BeamParameter which) {
  return which == BeamParameter::stiffness ? beam.stiffness_Nm2
         : which == BeamParameter::torsion ? beam.torsion_Nmprad
                                           : beam.mass_per_length_kgpm;
}

class FrequencyFit {
 public:
  FrequencyFit(const UniformBeam& beam, const std::vector<BeamParameter>& parameters,
               const std::vector<MeasuredFrequency>& measured)
      : start_(beam), parameters_(parameters), measured_(measured) {
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
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      value_of(beam, parameters_[i]) = std::exp(logs(static_cast<Eigen::Index>(i)));
    return beam;
  }
  Eigen::VectorXd logs_of(UniformBeam beam) const {
    Eigen::VectorXd logs(static_cast<Eigen::Index>(parameters_.size()));
    for (std::size_t i = 0; i < parameters_.size(); ++i)
      logs(static_cast<Eigen::Index>(i)) = std::log(value_of(beam, parameters_[i]));
    return logs;
  }

  Eigen::VectorXd model_logs(const UniformBeam& beam) const {
    const std::vector<BeamMode> modes = beam_modes(beam, highest_ + 1);
    Eigen::VectorXd logs(rows());
    for (Eigen::Index i = 0; i < rows(); ++i)
      logs(i) = std::log(modes[measured_[static_cast<std::size_t>(i)].mode].freq_Hz());
    return logs;
  }
  Eigen::VectorXd residual(const Eigen::VectorXd& logs) const {
    return (log_f_ - model_logs(beam_at(logs))).cwiseProduct(weight_);
  }
  bool is_within_limits(const Eigen::VectorXd& logs) const {
    if (!logs.allFinite()) return false;
    const double relative = beam_at(logs).relative_torsion();
    return start_.support != BeamSupport::torsion || (relative >= kMinTorsion && relative <= kMaxTorsion);
  }
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& logs) const {
    Eigen::MatrixXd columns(rows(), logs.size());
    for (Eigen::Index i = 0; i < logs.size(); ++i) {
      const Eigen::VectorXd step = kFitDifference * Eigen::VectorXd::Unit(logs.size(), i);
      columns.col(i) = (residual(logs + step) - residual(logs - step)) / (2 * kFitDifference);
    }
    return columns;
  }

  // The best start: the given values, or values from a range of T*. Only the fitted parameters change.
  Eigen::VectorXd best_start() const {
    Eigen::VectorXd best = logs_of(start_);
    double least = is_within_limits(best) ? residual(best).squaredNorm() : std::numeric_limits<double>::infinity();
    constexpr int kCandidates = 61;
    for (int i = 0; i < kCandidates; ++i) {
      const double relative = std::pow(10, -5 + 10.0 * i / (kCandidates - 1));
      const Eigen::VectorXd logs = logs_of(scaled(with_torsion(relative)));
      if (!is_within_limits(logs)) continue;
      const double chi2 = residual(logs).squaredNorm();
      if (chi2 < least) {
        least = chi2;
        best = logs;
      }
    }
    return best;
  }

  Eigen::VectorXd solve() const {
    Eigen::VectorXd logs = best_start();
    if (!is_within_limits(logs)) return logs;
    const auto within_limits = [&](const Eigen::VectorXd& at) {
      return is_within_limits(at) ? std::optional(residual(at)) : std::nullopt;
    };
    const auto jacobian_at = [&](const Eigen::VectorXd& at) { return jacobian(at); };
    levenberg_marquardt(logs, within_limits, jacobian_at, kBeamFitOptions);
    return logs;
  }

 private:
  Eigen::Index rows() const { return static_cast<Eigen::Index>(measured_.size()); }
  bool fits(BeamParameter which) const {
    return std::find(parameters_.begin(), parameters_.end(), which) != parameters_.end();
  }

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
  // Scales EI/ρA at constant T*, so that the frequencies fit on average.
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
  const std::vector<BeamParameter>& parameters_;
  const std::vector<MeasuredFrequency>& measured_;
  std::size_t highest_;
  Eigen::VectorXd log_f_, weight_;
};

}  // namespace

std::size_t max_beam_parameters(BeamSupport support) { return support == BeamSupport::torsion ? 2 : 1; }

BeamFit fit_beam(const UniformBeam& beam, const std::vector<BeamParameter>& parameters,
                 const std::vector<MeasuredFrequency>& measured) {
  assert(!parameters.empty() && parameters.size() <= max_beam_parameters(beam.support) &&
         measured.size() >= parameters.size());
  const FrequencyFit problem(beam, parameters, measured);
  const Eigen::VectorXd logs = problem.solve();
  BeamFit fit{.beam = problem.beam_at(logs), .chi2 = problem.residual(logs).squaredNorm()};
  const double relative = fit.beam.relative_torsion();
  fit.at_limit = beam.support == BeamSupport::torsion &&
                 (relative < kNearLimit * kMinTorsion || relative > kMaxTorsion / kNearLimit);
  const Eigen::VectorXd model = problem.model_logs(fit.beam).array().exp();
  fit.model_Hz.assign(model.begin(), model.end());
  const Eigen::MatrixXd columns = problem.jacobian(logs);
  const Eigen::MatrixXd gram = columns.transpose() * columns;
  const Eigen::MatrixXd covariance = inverse_gram(gram);
  const bool known = std::all_of(measured.begin(), measured.end(), [](const auto& one) { return one.std_Hz > 0; });
  const std::size_t spare = measured.size() - parameters.size();
  const auto degrees = static_cast<double>(spare);
  const double variance = known ? std::pow(birge_ratio(fit.chi2, degrees), 2) : spare > 0 ? fit.chi2 / degrees : 0;
  fit.parameters.reserve(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    FittedParameter parameter{.which = parameters[i], .value = value_of(fit.beam, parameters[i])};
    const double std = parameter.value * std::sqrt(variance * covariance(at, at));
    if ((known || spare > 0) && std::isfinite(std)) parameter.std = std;
    fit.parameters.push_back(parameter);
  }
  return fit;
}

TorsionFit fit_torsion(const std::vector<StaticReading>& readings, double stiffness_Nm2) {
  assert(!readings.empty());
  double xx = 0, xy = 0;
  const auto x_of = [](const StaticReading& r) { return r.load_N * r.lever_m * r.lever_m; };
  const auto y_of = [&](const StaticReading& r) {
    return r.deflection_m - x_of(r) * r.lever_m / (3 * stiffness_Nm2);  // (1)
  };
  for (const StaticReading& reading : readings) {
    xx += x_of(reading) * x_of(reading);
    xy += x_of(reading) * y_of(reading);
  }
  const double compliance = xy / xx;  // 1/T
  if (!(compliance > 0 && std::isfinite(compliance))) {
    throw InputError("bending of the beam alone exceeds the measured deflection", "static readings",
                     "check EI, and the readings in N, m, m", {"ei", "static"});
  }
  TorsionFit fit{.torsion_Nmprad = 1 / compliance};
  if (readings.size() < 2) return fit;
  double residual_square = 0;
  for (const StaticReading& reading : readings)
    residual_square += std::pow(y_of(reading) - compliance * x_of(reading), 2);
  const double variance = residual_square / static_cast<double>(readings.size() - 1) / xx;
  fit.std_Nmprad = std::sqrt(variance) / (compliance * compliance);
  return fit;
}

}  // namespace percuss::model
