#include "identify/hits/residues_by_hit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/fit/variable_projection.hpp"
#include "identify/hits/residue_ratios.hpp"
#include "identify/model/close_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kBroader = 1.3;     // damping ratio over the stronger mode's
constexpr double kWeaker = 0.5;      // peak over the stronger mode's
constexpr double kDisagreement = 5;  // standard deviations: of the best hit from the others, and of the χ² of all
// The least standard deviation of a residue ratio between the hits that counts as scatter. Noise of the force, which is
// largest at a resonance, causes a tenth of it; a pole that moves by a hundredth of the distance between the two poles
// causes twice as much.
constexpr double kMinSpread = 0.01;
constexpr double kMinShare = 0.6;  // smaller over larger residue: varying gains or directions keep it above this

double peak_of(const Mode& mode) {
  double power = 0;
  for (const Residue& residue : mode.residues) power += std::norm(residue.value);
  return std::sqrt(power) / mode.pole.damping_ratio;
}

// Whether a stronger and narrower mode of the window overlaps this mode.
bool is_under_another(const std::vector<Mode>& modes, const ModeWindow& window, std::size_t mode) {
  const Pole& pole = modes[mode].pole;
  return std::any_of(window.modes.begin(), window.modes.end(), [&](std::size_t other) {
    const Pole& strong = modes[other].pole;
    return other != mode && pole.damping_ratio > kBroader * strong.damping_ratio &&
           peak_of(modes[mode]) < kWeaker * peak_of(modes[other]) &&
           std::abs(pole.freq_Hz - strong.freq_Hz) < 0.5 * (pole.half_power_Hz() + strong.half_power_Hz());
  });
}

// Whether the ratios of the hits scatter significantly, and by more than kMinSpread.
bool scatter(const std::vector<ResidueRatio>& ratios) {
  ResidueRatio all;
  double chi2 = 0, degrees = -1;
  for (const ResidueRatio& one : ratios) {
    all.sum += one.sum;
    all.weight += one.weight;
  }
  for (const ResidueRatio& one : ratios) {
    if (!(one.weight > 0)) continue;
    chi2 += one.weight * std::pow(one.value() - all.value(), 2);
    ++degrees;
  }
  return degrees > 0 && chi2_deviate(chi2, degrees) > kDisagreement &&
         chi2 - degrees > std::pow(kMinSpread, 2) * all.weight;
}

// The fit of the single hits over a window, at the modes' poles.
class HitResidues {
 public:
  HitResidues(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes, const ModeWindow& window)
      : hits_(hits), modes_(modes), window_(window), residue_of_(residue_indices(set, hits)) {
    const std::vector<Pole> poles = window.poles(modes);
    const auto data = hit_data(set, hits, modes, window);
    const std::size_t terms = LocalFitOptions{}.residual_terms;
    freedom_ = std::max(1.0, static_cast<double>(window.count) - static_cast<double>(poles.size() + terms));
    const VectorXd ones = VectorXd::Ones(static_cast<Index>(data.size()));
    state_ = VariableProjection(hits.set, data, ones, window.first, window.count, terms).evaluate(poles);
  }
  // The difference between two modes' ratios, hit by hit: an error of the force's gain is common to both.
  std::vector<ResidueRatio> contrasts(std::size_t i, std::size_t k) const {
    const auto modes = static_cast<Index>(window_.modes.size());
    std::vector<MatrixXd> matrix(hits_.points.size(), MatrixXd::Zero(modes, modes));
    std::vector<VectorXd> right(hits_.points.size(), VectorXd::Zero(modes));
    for (const ProjectedPart& part : state_.parts) add_ratio_equations(part, matrix, right);
    std::vector<ResidueRatio> out(hits_.points.size());
    const auto first = static_cast<Index>(i), second = static_cast<Index>(k);
    for (std::size_t h = 0; h < out.size(); ++h) {
      const MatrixXd covariance = core::inverse_gram(matrix[h]);
      const VectorXd ratio = covariance * right[h];
      const double variance = covariance(first, first) + covariance(second, second) - 2 * covariance(first, second);
      if (variance > 0) out[h] = {.sum = (ratio(first) - ratio(second)) / variance, .weight = 1 / variance};
    }
    return out;
  }

  std::vector<ResidueRatio> ratios(std::size_t i) const {
    return residue_ratios(hits_, state_, modes_[window_.modes[i]], residue_of_, static_cast<Index>(i), freedom_);
  }

 private:
  // Adds a part's share of the normal equations of each hit's ratios, by the residues' covariance.
  void add_ratio_equations(const ProjectedPart& part, std::vector<MatrixXd>& matrix,
                           std::vector<VectorXd>& right) const {
    const Index modes = right.front().size();
    const MatrixXcd gram = core::inverse_gram(MatrixXcd(part.inverse_gram.topLeftCorner(modes, modes)));
    for (std::size_t n = 0; n < part.channels.size(); ++n) {
      const std::size_t o = part.channels[n], hit = hits_.set.channels[o].point;
      const auto column = static_cast<Index>(n);
      const double noise2 = std::max(part.residual.col(column).squaredNorm() / freedom_, 1e-300);
      VectorXcd expected(modes);
      for (Index m = 0; m < modes; ++m)
        expected(m) = modes_[window_.modes[static_cast<std::size_t>(m)]].residues[residue_of_[o]].value;
      const MatrixXcd weighted = (2 / noise2) * expected.conjugate().asDiagonal() * gram;
      matrix[hit] += (weighted * expected.asDiagonal()).real();
      right[hit] += (weighted * part.amplitude.col(column).head(modes)).real();
    }
  }

  const HitFrfs& hits_;
  const std::vector<Mode>& modes_;
  const ModeWindow& window_;
  std::vector<std::size_t> residue_of_;
  ProjectedState state_;
  double freedom_ = 1;
};

// Whether the hit with the most precise ratio contradicts the mean of the other hits.
bool disagree(const std::vector<ResidueRatio>& ratios) {
  const auto best =
      std::max_element(ratios.begin(), ratios.end(), [](const auto& a, const auto& b) { return a.weight < b.weight; });
  ResidueRatio rest;
  for (auto one = ratios.begin(); one != ratios.end(); ++one) {
    if (one == best) continue;
    rest.sum += one->sum;
    rest.weight += one->weight;
  }
  if (!(rest.weight > 0 && best->weight > 0)) return false;
  const double a = best->value(), b = rest.value();
  return std::abs(a - b) > kDisagreement * std::sqrt(1 / best->weight + 1 / rest.weight) &&
         std::min(a, b) < kMinShare * std::max(a, b);
}

}  // namespace

std::vector<std::size_t> modes_of_some_hits(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                                            const ModeWindow& window) {
  std::vector<std::size_t> some;
  if (std::none_of(window.modes.begin(), window.modes.end(),
                   [&](std::size_t m) { return is_under_another(modes, window, m); }))
    return some;
  const HitResidues residues(set, hits, modes, window);
  for (std::size_t i = 0; i < window.modes.size(); ++i) {
    const std::size_t m = window.modes[i];
    if (is_under_another(modes, window, m) && disagree(residues.ratios(i))) some.push_back(m);
  }
  return some;
}

bool residues_of_pair_scatter(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                              const ModeWindow& window) {
  const std::vector<Pole> poles = window.poles(modes);
  std::optional<HitResidues> residues;
  for (std::size_t i = 1; i < poles.size(); ++i) {
    if (!are_close(poles[i - 1], poles[i])) continue;
    if (!residues) residues.emplace(set, hits, modes, window);
    if (scatter(residues->contrasts(i - 1, i))) return true;
  }
  return false;
}

}  // namespace percuss::identify
