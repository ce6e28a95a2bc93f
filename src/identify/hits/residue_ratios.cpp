#include "identify/hits/residue_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kClearScatter = 5;  // normal deviate of χ²
// The least standard deviation of a residue ratio between the hits that counts as scatter. Noise of the force, which is
// largest at a resonance, causes a tenth of it; a pole that moves by a hundredth of the distance between the two poles
// causes twice as much.
constexpr double kMinSpread = 0.01;
constexpr double kMinNoise2 = 1e-300;

double noise2_of(const ProjectedPart& part, Index channel, double freedom) {
  return std::max(part.residual.col(channel).squaredNorm() / freedom, kMinNoise2);
}

}  // namespace

std::vector<ResidueRatio> HitResidues::ratios(std::size_t mode) const {
  std::vector<ResidueRatio> ratios(hits_.points.size());
  const auto at = static_cast<Index>(mode);
  for (const ProjectedPart& part : state_.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i];
      const auto column = static_cast<Index>(i);
      const Complex residue = expected(mode, o).value;
      // The real part has half the variance.
      const double scale = 2 / (noise2_of(part, column, freedom_) * part.inverse_gram(at, at).real());
      ResidueRatio& ratio = ratios[hits_.set.channels[o].point];
      ratio.sum += scale * (std::conj(residue) * part.amplitude(at, column)).real();
      ratio.weight += scale * std::norm(residue);
    }
  }
  return ratios;
}

std::vector<std::vector<HitResidue>> HitResidues::residues(std::size_t mode,
                                                           const std::vector<ResidueRatio>& ratios) const {
  std::vector<std::vector<HitResidue>> out(hits_.points.size());
  const auto at = static_cast<Index>(mode);
  for (const ProjectedPart& part : state_.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const std::size_t o = part.channels[i], hit = hits_.set.channels[o].point;
      const auto column = static_cast<Index>(i);
      const double variance = noise2_of(part, column, freedom_) * part.inverse_gram(at, at).real() / 2;
      const double weight = ratios[hit].weight;
      out[hit].push_back({.residue = residue_of_[o],
                          .value = part.amplitude(at, column),
                          .std = std::sqrt(variance),
                          .share = weight > 0 ? std::norm(expected(mode, o).value) / variance / weight : 1});
    }
  }
  return out;
}

std::vector<ResidueRatio> HitResidues::contrasts(std::size_t mode, std::size_t other) const {
  const auto modes = static_cast<Index>(window_.modes.size());
  std::vector<MatrixXd> matrix(hits_.points.size(), MatrixXd::Zero(modes, modes));
  std::vector<VectorXd> right(hits_.points.size(), VectorXd::Zero(modes));
  for (const ProjectedPart& part : state_.parts) add_ratio_equations(part, matrix, right);
  std::vector<ResidueRatio> out(hits_.points.size());
  const auto first = static_cast<Index>(mode), second = static_cast<Index>(other);
  for (std::size_t h = 0; h < out.size(); ++h) {
    const MatrixXd covariance = core::inverse_gram(matrix[h]);
    const VectorXd ratio = covariance * right[h];
    const double variance = covariance(first, first) + covariance(second, second) - 2 * covariance(first, second);
    if (variance > 0) out[h] = {.sum = (ratio(first) - ratio(second)) / variance, .weight = 1 / variance};
  }
  return out;
}

// Adds a part's share of the normal equations of each hit's ratios, by the residues' covariance.
void HitResidues::add_ratio_equations(const ProjectedPart& part, std::vector<MatrixXd>& matrix,
                                      std::vector<VectorXd>& right) const {
  const Index modes = right.front().size();
  const MatrixXcd gram = core::inverse_gram(MatrixXcd(part.inverse_gram.topLeftCorner(modes, modes)));
  for (std::size_t n = 0; n < part.channels.size(); ++n) {
    const std::size_t o = part.channels[n], hit = hits_.set.channels[o].point;
    const auto column = static_cast<Index>(n);
    VectorXcd residues(modes);
    for (Index m = 0; m < modes; ++m) residues(m) = expected(static_cast<std::size_t>(m), o).value;
    const MatrixXcd weighted = (2 / noise2_of(part, column, freedom_)) * residues.conjugate().asDiagonal() * gram;
    matrix[hit] += (weighted * residues.asDiagonal()).real();
    right[hit] += (weighted * part.amplitude.col(column).head(modes)).real();
  }
}

bool scatter_clearly(const std::vector<ResidueRatio>& ratios, const std::vector<std::size_t>& points) {
  const auto point_of = [&](std::size_t hit) { return points.empty() ? std::size_t{0} : points[hit]; };
  std::map<std::size_t, ResidueRatio> means;
  double chi2 = 0, degrees = 0, weight = 0;
  for (std::size_t h = 0; h < ratios.size(); ++h) {
    ResidueRatio& mean = means[point_of(h)];
    mean.sum += ratios[h].sum;
    mean.weight += ratios[h].weight;
  }
  for (std::size_t h = 0; h < ratios.size(); ++h) {
    if (!(ratios[h].weight > 0)) continue;
    chi2 += ratios[h].weight * std::pow(ratios[h].value() - means[point_of(h)].value(), 2);
    weight += ratios[h].weight;
    ++degrees;
  }
  for (const auto& [point, mean] : means) {
    if (mean.weight > 0) --degrees;
  }
  return degrees > 0 && chi2_deviate(chi2, degrees) > kClearScatter &&
         chi2 - degrees > std::pow(kMinSpread, 2) * weight;
}

}  // namespace percuss::identify
