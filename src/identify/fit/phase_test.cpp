#include "identify/fit/phase_test.hpp"

#include <algorithm>
#include <cmath>

#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPhaseTest = 4;   // standard deviations of a common phase: one real mode in 16 000 is called complex
constexpr double kSpreadTest = 6;  // standard deviations of a χ² sum over the FRFs

// Score and information of a phase error of the mode's residues.
struct PhaseEffect {
  double score = 0;        // score of the common phase
  double information = 0;  // of the common phase, at known poles
  VectorXd on_poles;       // [2 modes] cross information with the poles
  double chi2 = 0;         // Σ score²/information over the FRFs
  double channels = 0;
};

PhaseEffect effect_of(const JointProjection& projection, const JointState& state, std::size_t mode) {
  PhaseEffect effect{.on_poles = VectorXd::Zero(static_cast<Index>(2 * state.model.poles.size()))};
  for (const JointPart& part : state.parts) {
    const auto q = part.quadrature.col(static_cast<Index>(mode));
    const VectorXd cross = part.columns.transpose() * q;
    const VectorXd solved = part.inverse * cross;
    const double gram = q.squaredNorm() - cross.dot(solved);
    const VectorXd with_slopes = part.slopes.transpose() * (q - part.columns * solved);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto o = static_cast<Index>(i);
      const double noise = projection.noise()(static_cast<Index>(part.channels[i]));
      const double own = part.amplitude(static_cast<Index>(part.first[mode]), o) / noise;
      const double score = own * q.dot(part.residual.col(o)) / noise;
      const double information = own * own * gram;
      effect.score += score;
      effect.information += information;
      if (information > 0) effect.chi2 += score * score / information;
      ++effect.channels;
      effect.on_poles += own * (projection.residue_matrix(state, part, o).transpose() * with_slopes);
    }
  }
  return effect;
}

// Variance of the force's mean phase over the points, near a pole.
double phase_variance(const FrfDataset& set, const Pole& pole) {
  double sum = 0;
  for (std::size_t p = 0; p < set.points.size(); ++p) sum += std::pow(gain_std(set, p, pole.freq_Hz), 2);
  return sum / static_cast<double>(set.points.size() * set.points.size());
}

}  // namespace

double phase_test_statistic(const JointProjection& projection, const JointState& state, std::size_t mode,
                            const Eigen::MatrixXd& covariance) {
  const PhaseEffect effect = effect_of(projection, state, mode);
  const double information = effect.information - effect.on_poles.dot(covariance * effect.on_poles);
  if (!(information > 1e-12 * effect.information)) return 0;
  const double prior = phase_variance(projection.set(), state.model.poles[mode]);
  const double common = effect.score * effect.score / (information + prior * information * information);
  const double expected = effect.channels + prior * effect.information;
  return std::max(common / (kPhaseTest * kPhaseTest),
                  effect.chi2 / (expected * (1 + kSpreadTest * std::sqrt(2 / effect.channels))));
}

}  // namespace percuss::identify
