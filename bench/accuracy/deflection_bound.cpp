#include "deflection_bound.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "deflection_truth.hpp"
#include "synth/schedule.hpp"

namespace percuss::accuracy {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFreqStep = 1e-6, kDampingStep = 1e-4;  // relative, of central differences

std::vector<synth::SynthPole> poles_of(const synth::Truth& truth) {
  std::vector<synth::SynthPole> poles;
  for (const synth::SynthMode& mode : truth.spec.modes) poles.push_back({mode.freq_Hz, mode.damping_ratio});
  return poles;
}

// Changes parameter p (f and ζ of each mode in turn) by `steps` difference steps, and returns the step.
double move_parameter(std::vector<synth::SynthPole>& poles, Index p, double steps) {
  synth::SynthPole& pole = poles[static_cast<std::size_t>(p / 2)];
  double& value = p % 2 == 0 ? pole.freq_Hz : pole.damping_ratio;
  const double step = value * (p % 2 == 0 ? kFreqStep : kDampingStep);
  value += steps * step;
  return step;
}

synth::Pulse pulse_of(const synth::Truth& truth, std::size_t hit) {
  return synth::pulses_of(truth.spec, truth.hits[hit]).front();
}

// The acceleration of one mode with residue 1 over a row.
VectorXd row_of_mode(const synth::Truth& truth, const synth::Pulse& pulse, const synth::SynthPole& pole) {
  const synth::PulseBasis basis =
      synth::pulse_basis(pulse, truth.spec.fs_Hz, std::span(&pole, 1), 0, truth.spec.samples);
  VectorXd row = VectorXd::Zero(static_cast<Index>(truth.spec.samples));
  const auto add = [&](const std::vector<double>& x) {
    for (std::size_t i = 0; i < x.size(); ++i) row[static_cast<Index>(basis.first + i)] += x[i];
  };
  add(basis.regular_N.front());
  add(basis.force_N);
  return row;
}

// Columns of the Jacobian of one row: f and ζ for residue 1, residue, bias, drift.
MatrixXd columns_of(const synth::Truth& truth, std::size_t hit) {
  const std::vector<synth::SynthPole> poles = poles_of(truth);
  const auto modes = static_cast<Index>(poles.size()), samples = static_cast<Index>(truth.spec.samples);
  const synth::Pulse pulse = pulse_of(truth, hit);
  MatrixXd columns(samples, 3 * modes + 2);
  for (Index p = 0; p < 2 * modes; ++p) {
    std::vector<synth::SynthPole> up = poles, down = poles;
    const double step = move_parameter(up, p, 1);
    move_parameter(down, p, -1);
    const auto m = static_cast<std::size_t>(p / 2);
    columns.col(p) = (row_of_mode(truth, pulse, up[m]) - row_of_mode(truth, pulse, down[m])) / (2 * step);
  }
  for (Index m = 0; m < modes; ++m)
    columns.col(2 * modes + m) = row_of_mode(truth, pulse, poles[static_cast<std::size_t>(m)]);
  columns.col(3 * modes).setOnes();
  columns.col(3 * modes + 1).setLinSpaced(samples, -1, 1);
  return columns;
}

MatrixXd inverse_of(const MatrixXd& m) {
  const VectorXd scale = m.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd unit = scale.asDiagonal() * m * scale.asDiagonal();
  return scale.asDiagonal() * unit.inverse() * scale.asDiagonal();
}

// `m` after the elimination of its rows and columns from `kept` on: the Schur complement.
MatrixXd eliminated(const MatrixXd& m, Index kept) {
  const Index removed = m.rows() - kept;
  return m.topLeftCorner(kept, kept) - m.topRightCorner(kept, removed) *
                                           inverse_of(m.bottomRightCorner(removed, removed)) *
                                           m.bottomLeftCorner(removed, kept);
}

// The information of one channel on f, ζ and its own residues, from all rows.
MatrixXd channel_information(const synth::Truth& truth, const std::vector<MatrixXd>& products, std::size_t channel) {
  const auto modes = static_cast<Index>(truth.spec.modes.size());
  VectorXd scale = VectorXd::Ones(3 * modes + 2);
  for (Index p = 0; p < 2 * modes; ++p) scale[p] = truth.residue_per_kg[0][channel][static_cast<std::size_t>(p / 2)];
  MatrixXd sum = MatrixXd::Zero(3 * modes, 3 * modes);
  for (const MatrixXd& product : products)
    sum += eliminated(scale.asDiagonal() * product * scale.asDiagonal(), 3 * modes);
  return sum / std::pow(truth.accel_noise_mps2[channel], 2);
}

// ∂w/∂(f, ζ, A) at the peak of hit 0, relative to it. The time of the peak does not matter, because dw/dt = 0 there.
VectorXd gradient(const synth::Truth& truth, std::size_t channel) {
  const std::vector<synth::SynthPole> poles = poles_of(truth);
  const std::vector<double>& residues = truth.residue_per_kg[0][channel];
  const auto modes = static_cast<Index>(poles.size());
  const synth::Pulse pulse = pulse_of(truth, 0);
  const TrueDeflection exact(pulse, poles);
  const TrueDeflection::Peak peak = exact.peak(residues);
  VectorXd g(3 * modes);
  for (Index p = 0; p < 2 * modes; ++p) {
    std::vector<synth::SynthPole> up = poles, down = poles;
    const double step = move_parameter(up, p, 1);
    move_parameter(down, p, -1);
    g[p] = (TrueDeflection(pulse, up).at_m(peak.time_s, residues) -
            TrueDeflection(pulse, down).at_m(peak.time_s, residues)) /
           (2 * step);
  }
  for (Index m = 0; m < modes; ++m) {
    std::vector<double> one(residues.size());
    one[static_cast<std::size_t>(m)] = 1;
    g[2 * modes + m] = exact.at_m(peak.time_s, one);
  }
  return g / peak.value_m;
}

}  // namespace

std::vector<double> deflection_bound(const synth::Truth& truth) {
  const auto poles = static_cast<Index>(2 * truth.spec.modes.size());
  std::vector<MatrixXd> products, information;
  for (std::size_t hit = 0; hit < truth.hits.size(); ++hit) {
    const MatrixXd columns = columns_of(truth, hit);
    products.emplace_back(columns.transpose() * columns);
  }
  MatrixXd shared = MatrixXd::Zero(poles, poles);  // information of all channels on f and ζ
  for (std::size_t c = 0; c < truth.accel_noise_mps2.size(); ++c) {
    information.push_back(channel_information(truth, products, c));
    shared += eliminated(information.back(), poles);
  }
  std::vector<double> bound;
  for (std::size_t c = 0; c < information.size(); ++c) {
    MatrixXd all = information[c];
    all.topLeftCorner(poles, poles) += shared - eliminated(information[c], poles);
    const VectorXd g = gradient(truth, c);
    bound.push_back(std::sqrt(g.dot(inverse_of(all) * g)));  // (1)
  }
  return bound;
}

}  // namespace percuss::accuracy
