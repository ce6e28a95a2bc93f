#include "model/bat/structure_fit.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"
#include "model/bat/bat_modes.hpp"

namespace percuss::model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr LevenbergMarquardtOptions kStructureFitOptions{.max_steps = 100, .max_damping = 1e12, .step_tolerance = 1e-9};
constexpr double kLogDifference = 1e-4;    // for central differences: their relative error is 1e-8
constexpr double kMaxLogChange = 25;       // of a parameter from its start
constexpr double kMinIndependence = 1e-7;  // smallest eigenvalue of the columns' correlation: an angle of 4e-4 rad
constexpr double kMinSensitivity = 1e-6;   // ∂ ln f/∂ ln p: a parameter with less leaves the frequencies unchanged
constexpr std::array kSpringDecades = {0.0, -2.0, 2.0, -4.0, 4.0};  // from the stated spring

double& value_of(BeamStructure& structure, StructureParameter which) {
  switch (which) {
    case StructureParameter::young:
      return structure.material.young_Pa;
    case StructureParameter::shear:
      return structure.material.shear_Pa;
    case StructureParameter::density:
      return structure.material.density_kgpm3;
    case StructureParameter::torsion:
      return structure.support.torsion_Nmprad;
    default:
      return structure.added.back().mass_kg;
  }
}

class StructureProblem {
 public:
  StructureProblem(BeamStructure structure, const std::vector<StructureParameter>& parameters,
                   const std::vector<MeasuredMode>& measured, const StructureFitOptions& options)
      : start_(std::move(structure)), parameters_(parameters), measured_(measured), options_(options) {
    for (const MeasuredMode& one : measured) highest_ = std::max(highest_, one.elastic);
    start_logs_ = VectorXd(std::ssize(parameters));
    for (Index i = 0; i < start_logs_.size(); ++i)
      start_logs_(i) = std::log(value_of(start_, parameters[static_cast<std::size_t>(i)]));
  }

  BeamStructure structure_at(const VectorXd& logs) const {
    BeamStructure structure = start_;
    for (Index i = 0; i < logs.size(); ++i)
      value_of(structure, parameters_[static_cast<std::size_t>(i)]) = std::exp(logs(i));
    if (options_.total_mass_kg) structure.material.density_kgpm3 = density_for_mass(structure, *options_.total_mass_kg);
    return structure;
  }
  VectorXd model_Hz(const VectorXd& logs) const {
    const BatModes modes =
        bat_modes(structure_at(logs), {.modes = highest_ + 1, .max_element_fraction = options_.max_element_fraction});
    VectorXd out(std::ssize(measured_));
    for (Index i = 0; i < out.size(); ++i)
      out(i) = modes.freq_Hz(static_cast<Index>(measured_[static_cast<std::size_t>(i)].elastic));
    return out;
  }
  VectorXd residual(const VectorXd& logs) const {
    VectorXd out = model_Hz(logs);
    for (Index i = 0; i < out.size(); ++i) {
      const MeasuredMode& one = measured_[static_cast<std::size_t>(i)];
      out(i) = (std::log(one.freq_Hz) - std::log(out(i))) * (one.std_Hz > 0 ? one.freq_Hz / one.std_Hz : 1);
    }
    return out;
  }
  // Nothing outside the limits: also where the held total mass leaves no density.
  std::optional<VectorXd> residual_within_limits(const VectorXd& logs) const {
    if (!((logs - start_logs_).cwiseAbs().maxCoeff() <= kMaxLogChange)) return std::nullopt;
    try {
      return residual(logs);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }
  MatrixXd jacobian(const VectorXd& logs) const {
    MatrixXd columns(std::ssize(measured_), logs.size());
    for (Index i = 0; i < logs.size(); ++i) {
      const VectorXd step = kLogDifference * VectorXd::Unit(logs.size(), i);
      columns.col(i) = (residual(logs + step) - residual(logs - step)) / (2 * kLogDifference);
    }
    return columns;
  }

  // The best of several fits: frequencies saturate for a soft and for a stiff spring, so that a fit may end at either.
  VectorXd solve() const {
    VectorXd best = start_logs_;
    double least = std::numeric_limits<double>::infinity();
    for (const VectorXd& start : starts()) {
      const VectorXd logs = fitted_from(start);
      const auto rest = residual_within_limits(logs);
      if (!rest || !(rest->squaredNorm() < least)) continue;
      least = rest->squaredNorm();
      best = logs;
    }
    return best;
  }

 private:
  // `start` itself where a step on the way leads to a spring too soft or too stiff for the elements.
  VectorXd fitted_from(const VectorXd& start) const {
    VectorXd logs = start;
    try {
      levenberg_marquardt(
          logs, [&](const VectorXd& at) { return residual_within_limits(at); },
          [&](const VectorXd& at) { return jacobian(at); }, kStructureFitOptions);
    } catch (const InputError&) {
      return start;
    }
    return logs;
  }

  std::vector<VectorXd> starts() const {
    const auto spring = std::find(parameters_.begin(), parameters_.end(), StructureParameter::torsion);
    if (spring == parameters_.end()) return {start_logs_};
    std::vector<VectorXd> out;
    for (const double decades : kSpringDecades) {
      VectorXd logs = start_logs_;
      logs(spring - parameters_.begin()) += std::log(10.0) * decades;
      if (residual_within_limits(logs)) out.push_back(logs);
    }
    return out;
  }

  BeamStructure start_;
  const std::vector<StructureParameter>& parameters_;
  const std::vector<MeasuredMode>& measured_;
  StructureFitOptions options_;
  std::size_t highest_ = 0;
  VectorXd start_logs_;
};

// Refuses columns that nearly depend on each other, or that are nearly zero.
void require_determined(const MatrixXd& columns, const std::vector<MeasuredMode>& measured) {
  VectorXd least(columns.rows());
  for (Index i = 0; i < least.size(); ++i) {
    const MeasuredMode& one = measured[static_cast<std::size_t>(i)];
    least(i) = kMinSensitivity * (one.std_Hz > 0 ? one.freq_Hz / one.std_Hz : 1);
  }
  const MatrixXd unit = columns.colwise().normalized();
  const bool weak = !(columns.colwise().norm().minCoeff() > least.norm());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> correlation(unit.transpose() * unit, Eigen::EigenvaluesOnly);
  if (!weak && correlation.eigenvalues()(0) > kMinIndependence) return;
  throw InputError("the measured frequencies do not determine the parameters", "fit",
                   "fit fewer parameters, hold the mass, or measure more modes", {"fit", "total_mass", "measured"});
}

}  // namespace

StructureFit fit_structure(const BeamStructure& structure, const std::vector<StructureParameter>& parameters,
                           const std::vector<MeasuredMode>& measured, const StructureFitOptions& options) {
  assert(!parameters.empty() && measured.size() >= parameters.size());
  const StructureProblem problem(structure, parameters, measured, options);
  const VectorXd logs = problem.solve();
  const MatrixXd columns = problem.jacobian(logs);
  require_determined(columns, measured);
  StructureFit fit{.structure = problem.structure_at(logs),
                   .parameters = {},
                   .model_Hz = {},
                   .chi2 = problem.residual(logs).squaredNorm()};
  const VectorXd model_Hz = problem.model_Hz(logs);
  fit.model_Hz.assign(model_Hz.begin(), model_Hz.end());
  const MatrixXd covariance = inverse_gram(MatrixXd(columns.transpose() * columns));
  const bool known = std::all_of(measured.begin(), measured.end(), [](const auto& one) { return one.std_Hz > 0; });
  const std::size_t spare = measured.size() - parameters.size();
  const auto degrees = static_cast<double>(spare);
  const double variance = known ? std::pow(birge_ratio(fit.chi2, degrees), 2) : spare > 0 ? fit.chi2 / degrees : 0;
  fit.parameters.reserve(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Index>(i);
    FittedStructureParameter one{.which = parameters[i], .value = value_of(fit.structure, parameters[i])};
    if (known || spare > 0) one.std = one.value * std::sqrt(variance * covariance(at, at));
    fit.parameters.push_back(one);
  }
  return fit;
}

}  // namespace percuss::model
