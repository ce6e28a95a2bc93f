#include "synth/cramer_rao_bound.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/budget.hpp"
#include "core/parallel/parallel.hpp"
#include "synth/schedule.hpp"

namespace percuss::synth {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFreqStep = 1e-6, kDampingStep = 1e-4;     // relative: truncation and rounding both near 1e-9
constexpr std::size_t kChunkValues = std::size_t{1} << 20;  // per chunk: memory does not grow with the record
constexpr double kUnseen = 1e99;                            // standard deviation for a mode that no channel measures

// The poles, then the poles with f increased, f decreased, ζ increased, ζ decreased.
std::vector<SynthPole> poles_and_neighbours(const SynthSpec& spec) {
  std::vector<SynthPole> out;
  for (const auto& [df, dz] :
       {std::pair{0.0, 0.0}, {kFreqStep, 0.0}, {-kFreqStep, 0.0}, {0.0, kDampingStep}, {0.0, -kDampingStep}}) {
    for (const SynthMode& m : spec.modes) out.push_back({m.freq_Hz * (1 + df), m.damping_ratio * (1 + dz)});
  }
  return out;
}

void add_to(std::span<const double> values, double scale, std::size_t offset, Eigen::Ref<VectorXd> column) {
  for (std::size_t i = 0; i < values.size(); ++i) column[static_cast<Index>(offset + i)] += scale * values[i];
}

// Adds the columns for unit residues from sample `first` on: ∂/∂f_r and ∂/∂ζ_r (both still to be multiplied by the
// residue), ∂/∂residue_r, ∂/∂(rigid-body accelerance).
void add_columns(const SynthSpec& spec, const Pulse& pulse, std::span<const SynthPole> poles, std::size_t first,
                 MatrixXd& columns) {
  const PulseBasis basis = pulse_basis(pulse, spec.fs_Hz, poles, first, static_cast<std::size_t>(columns.rows()));
  const std::size_t modes = spec.modes.size(), offset = basis.first - first;
  const auto column = [&](std::size_t i) { return columns.col(static_cast<Index>(i)); };
  for (std::size_t r = 0; r < modes; ++r) {
    const double per_Hz = 1 / (2 * kFreqStep * spec.modes[r].freq_Hz);
    const double per_unit = 1 / (2 * kDampingStep * spec.modes[r].damping_ratio);
    add_to(basis.regular_N[modes + r], per_Hz, offset, column(r));
    add_to(basis.regular_N[2 * modes + r], -per_Hz, offset, column(r));
    add_to(basis.regular_N[3 * modes + r], per_unit, offset, column(modes + r));
    add_to(basis.regular_N[4 * modes + r], -per_unit, offset, column(modes + r));
    add_to(basis.regular_N[r], 1, offset, column(2 * modes + r));
    add_to(basis.force_N, 1, offset, column(2 * modes + r));
  }
  add_to(basis.force_N, 1, offset, column(3 * modes));
}

// Inner products of these columns over one row with the given hits.
MatrixXd row_products(const Truth& truth, std::span<const TrueHit> hits) {
  const auto size = static_cast<Index>(3 * truth.spec.modes.size() + 1);
  const std::vector<SynthPole> poles = poles_and_neighbours(truth.spec);
  const std::size_t chunk = kChunkValues / static_cast<std::size_t>(size);
  std::vector<Pulse> pulses;
  for (const TrueHit& hit : hits) {
    for (const Pulse& pulse : pulses_of(truth.spec, hit)) pulses.push_back(pulse);
  }
  MatrixXd sum = MatrixXd::Zero(size, size);
  for (std::size_t first = 0; first < truth.spec.samples; first += chunk) {
    check_budget();
    const std::size_t count = std::min(chunk, truth.spec.samples - first);
    MatrixXd columns = MatrixXd::Zero(static_cast<Index>(count), size);
    for (const Pulse& pulse : pulses) {
      const PulseSupport support = pulse_support(pulse, truth.spec.fs_Hz, poles);
      if (support.first >= static_cast<double>(first + count) || support.last <= static_cast<double>(first)) continue;
      add_columns(truth.spec, pulse, poles, first, columns);
    }
    sum.noalias() += columns.transpose() * columns;
  }
  return sum;
}

// Inverse of a symmetric positive definite matrix whose rows differ in scale. A row of zeros stays zero.
MatrixXd scaled_inverse(const MatrixXd& m) {
  const VectorXd scale = m.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
  MatrixXd unit = scale.asDiagonal() * m * scale.asDiagonal();
  for (Index i = 0; i < unit.rows(); ++i) {
    if (scale[i] == 0) unit(i, i) = 1;
  }
  return scale.asDiagonal() * unit.inverse() * scale.asDiagonal();
}

// The contribution of one channel at one point to the matrix of (f, ζ). Its residues and rigid-body accelerance are
// eliminated.
MatrixXd channel_information(const MatrixXd& products, const std::vector<double>& residue_per_kg) {
  const auto modes = static_cast<Index>(residue_per_kg.size());
  const VectorXd residue = Eigen::Map<const VectorXd>(residue_per_kg.data(), modes).replicate(2, 1);
  const MatrixXd global = residue.asDiagonal() * products.topLeftCorner(2 * modes, 2 * modes) * residue.asDiagonal();
  const MatrixXd cross = residue.asDiagonal() * products.topRightCorner(2 * modes, modes + 1);
  return global - cross * scaled_inverse(products.bottomRightCorner(modes + 1, modes + 1)) * cross.transpose();
}

}  // namespace

CramerRaoBound cramer_rao_bound(const Truth& truth, std::size_t threads) {
  const auto modes = static_cast<Index>(truth.spec.modes.size());
  assert(modes > 0);
  const bool one_row = truth.spec.layout == SynthLayout::continuous;
  const std::size_t rows = rows_per_run(truth.spec);
  std::vector<MatrixXd> products(rows);
  parallel_for(rows, threads, [&](std::size_t row) {
    products[row] = row_products(truth, one_row ? std::span(truth.hits) : std::span(truth.hits).subspan(row, 1));
  });
  MatrixXd information = MatrixXd::Zero(2 * modes, 2 * modes);
  for (std::size_t p = 0; p < truth.residue_per_kg.size(); ++p) {
    MatrixXd of_point = MatrixXd::Zero(3 * modes + 1, 3 * modes + 1);
    for (std::size_t row = 0; row < rows; ++row) {
      if (truth.hits[row].point == p) of_point += products[row];
    }
    if (of_point.isZero(0)) continue;  // all its hits are missing
    for (std::size_t c = 0; c < truth.accel_noise_mps2.size(); ++c) {
      information += channel_information(of_point, truth.residue_per_kg[p][c]) / std::pow(truth.accel_noise_mps2[c], 2);
    }
  }
  const VectorXd variance = scaled_inverse(information).diagonal();
  CramerRaoBound bound;
  for (Index r = 0; r < modes; ++r) {
    const auto std_of = [&](Index i) { return variance[i] > 0 ? std::sqrt(variance[i]) : kUnseen; };
    bound.freq_std_Hz.push_back(std_of(r));
    bound.damping_ratio_std.push_back(std_of(modes + r));
  }
  return bound;
}

}  // namespace percuss::synth
