#include "identify/variable_projection.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace percuss {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VariableProjection::VariableProjection(const FrfSet& set, const std::vector<VectorXcd>& data, VectorXd weight,
                                       std::size_t first, std::size_t count, std::size_t polynomial_terms)
    : set_(set), data_(data), weight_(std::move(weight)), first_(first), count_(count), terms_(polynomial_terms) {
  for (std::size_t o = 0; o < set.outputs.size(); ++o) {
    const std::size_t point = set.outputs[o].point;
    if (by_point_.size() <= point) by_point_.resize(point + 1);
    by_point_[point].push_back(o);
    together_.front().push_back(o);
  }
}

ProjectedState VariableProjection::evaluate(const std::vector<Pole>& poles) const {
  ProjectedState state;
  for (const auto& outputs : outputs_alike(poles)) {
    if (outputs.empty()) continue;
    state.parts.push_back(solve(outputs, poles));
    const ProjectedPart& part = state.parts.back();
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const double w = weight_(static_cast<Index>(outputs[i]));
      state.cost += part.residual.col(static_cast<Index>(i)).squaredNorm() / (w * w);
    }
  }
  return state;
}

std::pair<MatrixXd, VectorXd> VariableProjection::normal_equations(const ProjectedState& state,
                                                                   std::size_t modes) const {
  const auto n = static_cast<Index>(2 * modes);
  MatrixXd matrix = MatrixXd::Zero(n, n);
  VectorXd right = VectorXd::Zero(n);
  for (const ProjectedPart& part : state.parts) {
    MatrixXcd derivative(part.basis.rows(), n);
    for (std::size_t m = 0; m < modes; ++m) {
      derivative.col(static_cast<Index>(2 * m)) = part.columns[m].by_freq;
      derivative.col(static_cast<Index>(2 * m + 1)) = part.columns[m].by_damping;
    }
    derivative -= part.basis * (part.basis.adjoint() * derivative);
    const MatrixXcd gram = derivative.adjoint() * derivative;
    const MatrixXcd slope = derivative.adjoint() * part.residual;
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      const double w = weight_(static_cast<Index>(part.outputs[i]));
      const auto column = static_cast<Index>(i);
      for (Index r = 0; r < n; ++r) {
        const Complex amplitude = std::conj(part.amplitude(r / 2, column));
        right(r) += (amplitude * slope(r, column)).real() / (w * w);
        for (Index c = 0; c < n; ++c)
          matrix(r, c) += (amplitude * gram(r, c) * part.amplitude(c / 2, column)).real() / (w * w);
      }
    }
  }
  return {matrix, right};
}

// Outputs with equal columns: all of them once every mode has decayed within the record, else those of one point.
const std::vector<std::vector<std::size_t>>& VariableProjection::outputs_alike(const std::vector<Pole>& poles) const {
  const bool decayed = std::all_of(poles.begin(), poles.end(), [&](const Pole& pole) {
    return decays_within(pole, set_.points.front(), set_.lines);
  });
  return decayed ? together_ : by_point_;
}

ProjectedPart VariableProjection::solve(const std::vector<std::size_t>& outputs, const std::vector<Pole>& poles) const {
  ProjectedPart part;
  part.outputs = outputs;
  const PointForce& force = set_.points[set_.outputs[outputs.front()].point];
  const auto lines = static_cast<Index>(count_);
  const auto modes = static_cast<Index>(poles.size());
  const auto terms = static_cast<Index>(terms_);
  MatrixXcd columns(lines, modes + terms);
  for (Index m = 0; m < modes; ++m) {
    part.columns.push_back(mode_column(poles[static_cast<std::size_t>(m)], force, set_.lines, first_, count_));
    columns.col(m) = part.columns.back().value;
  }
  const VectorXd x = VectorXd::LinSpaced(lines, -1, 1);
  VectorXd power = VectorXd::Ones(lines);
  for (Index term = 0; term < terms; ++term, power = power.cwiseProduct(x))
    columns.col(modes + term) = power.cast<Complex>();
  const Eigen::HouseholderQR<MatrixXcd> qr(columns);
  part.basis = qr.householderQ() * MatrixXcd::Identity(lines, columns.cols());
  part.triangle = qr.matrixQR().topRows(columns.cols()).triangularView<Eigen::Upper>();
  MatrixXcd data(lines, static_cast<Index>(outputs.size()));
  for (std::size_t i = 0; i < outputs.size(); ++i) data.col(static_cast<Index>(i)) = data_[outputs[i]];
  const MatrixXcd projected = part.basis.adjoint() * data;
  part.amplitude = part.triangle.triangularView<Eigen::Upper>().solve(projected);
  part.residual = data - part.basis * projected;
  return part;
}

}  // namespace percuss
