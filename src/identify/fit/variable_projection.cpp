#include "identify/fit/variable_projection.hpp"

#include <algorithm>
#include <utility>

#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"

namespace percuss::identify {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VariableProjection::VariableProjection(const FrfDataset& set, const std::vector<VectorXcd>& data, VectorXd noise_scale,
                                       std::size_t first, std::size_t count, std::size_t polynomial_terms)
    : set_(set),
      polynomial_(orthonormal_polynomials(static_cast<Index>(count), static_cast<Index>(polynomial_terms))),
      data_(static_cast<Index>(count), static_cast<Index>(data.size())),
      noise_scale_(std::move(noise_scale)),
      first_(first),
      count_(count),
      by_point_(channels_by_point(set)) {
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    together_.front().push_back(o);
    data_.col(static_cast<Index>(o)) = data[o];
  }
  project(data_);
}

void VariableProjection::project(MatrixXcd& columns) const {
  subtract_product(columns, polynomial_, transposed_product(polynomial_, columns));
}

ProjectedState VariableProjection::evaluate(const std::vector<Pole>& poles) const {
  ProjectedState state;
  std::vector<PointColumns> modes;
  modes.reserve(poles.size());
  for (const Pole& pole : poles) modes.emplace_back(pole, set_, first_, count_);
  for (const auto& channels : channels_with_equal_columns(poles)) {
    if (channels.empty()) continue;
    state.parts.push_back(solve(channels, modes));
    const ProjectedPart& part = state.parts.back();
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const double w = noise_scale_(static_cast<Index>(channels[i]));
      state.cost += part.residual.col(static_cast<Index>(i)).squaredNorm() / (w * w);
    }
  }
  return state;
}

NormalEquations VariableProjection::normal_equations(const ProjectedState& state, std::size_t modes) const {
  return std::move(sums_of_normal_equations(state, modes, 1, [](std::size_t) { return std::size_t{0}; }).front());
}

std::vector<NormalEquations> VariableProjection::sums_of_normal_equations(
    const ProjectedState& state, std::size_t modes, std::size_t sums,
    const std::function<std::size_t(std::size_t)>& sum_of) const {
  const auto n = static_cast<Index>(2 * modes);
  std::vector<NormalEquations> normal(sums, {.matrix = MatrixXd::Zero(n, n), .right = VectorXd::Zero(n)});
  for (const ProjectedPart& part : state.parts)
    add_normal_equations(part, [&](std::size_t o) -> NormalEquations& { return normal[sum_of(o)]; });
  return normal;
}

std::vector<NormalEquations> VariableProjection::normal_equations_by_point(const ProjectedState& state,
                                                                           std::size_t modes) const {
  return sums_of_normal_equations(state, modes, set_.points.size(),
                                  [&](std::size_t o) { return set_.channels[o].point; });
}

std::vector<NormalEquations> VariableProjection::normal_equations_by_channel(const ProjectedState& state,
                                                                             std::size_t modes) const {
  return sums_of_normal_equations(state, modes, set_.channels.size(), [](std::size_t o) { return o; });
}

void VariableProjection::add_normal_equations(const ProjectedPart& part,
                                              const std::function<NormalEquations&(std::size_t)>& sum_of) const {
  const Index n = part.slopes.cols();
  const MatrixXcd poly = transposed_product(polynomial_, part.slopes);
  const MatrixXcd cross = adjoint_product(part.columns, part.slopes);
  const MatrixXcd gram = adjoint_gram(part.slopes) - adjoint_gram(poly) -
                         adjoint_product(cross, part.inverse_gram.lazyProduct(cross).eval());
  const MatrixXcd score = adjoint_product(part.slopes, part.residual);
  for (std::size_t i = 0; i < part.channels.size(); ++i) {
    NormalEquations& normal = sum_of(part.channels[i]);
    const double w = noise_scale_(static_cast<Index>(part.channels[i]));
    const auto column = static_cast<Index>(i);
    for (Index r = 0; r < n; ++r) {
      const Complex amplitude = std::conj(part.amplitude(r / 2, column));
      normal.right(r) += (amplitude * score(r, column)).real() / (w * w);
      for (Index c = 0; c < n; ++c)
        normal.matrix(r, c) += (amplitude * gram(r, c) * part.amplitude(c / 2, column)).real() / (w * w);
    }
  }
}

MatrixXcd VariableProjection::projected_slopes(const ProjectedPart& part) const {
  MatrixXcd slopes = part.slopes;
  project_out(part, slopes);
  return slopes;
}

void VariableProjection::project_out(const ProjectedPart& part, MatrixXcd& further) const {
  project(further);
  subtract_product(further, part.columns, part.inverse_gram.lazyProduct(adjoint_product(part.columns, further)).eval());
}

MatrixXcd VariableProjection::residue_derivatives(const ProjectedPart& part, Index channel) const {
  MatrixXcd derivatives = -part.inverse_gram * adjoint_product(part.columns, part.slopes);
  for (Index c = 0; c < derivatives.cols(); ++c) derivatives.col(c) *= part.amplitude(c / 2, channel);
  return derivatives;
}

// FRFs with equal columns: all FRFs where every mode decays within the record, else the FRFs of one point.
const std::vector<std::vector<std::size_t>>& VariableProjection::channels_with_equal_columns(
    const std::vector<Pole>& poles) const {
  const bool decayed = std::all_of(poles.begin(), poles.end(), [&](const Pole& pole) {
    return decays_within_record(pole, set_.points.front(), set_.lines);
  });
  return decayed ? together_ : by_point_;
}

ProjectedPart VariableProjection::solve(const std::vector<std::size_t>& channels,
                                        const std::vector<PointColumns>& mode_columns) const {
  ProjectedPart part;
  part.channels = channels;
  const PointForce& force = set_.points[set_.channels[channels.front()].point];
  const auto lines = static_cast<Index>(count_);
  const auto modes = static_cast<Index>(mode_columns.size());
  part.columns.resize(lines, modes);
  part.slopes.resize(lines, 2 * modes);
  for (Index m = 0; m < modes; ++m) {
    const ModeColumn mode = mode_columns[static_cast<std::size_t>(m)].at(force);
    part.columns.col(m) = mode.value;
    part.slopes.col(2 * m) = mode.by_freq;
    part.slopes.col(2 * m + 1) = mode.by_damping;
  }
  project(part.columns);
  part.inverse_gram = inverse_gram(adjoint_gram(part.columns));
  auto [amplitude, residual] = fit_columns(part.columns, part.inverse_gram, data_, channels);
  part.amplitude = std::move(amplitude);
  part.residual = std::move(residual);
  return part;
}

}  // namespace percuss::identify
