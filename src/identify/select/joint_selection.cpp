#include "identify/select/joint_selection.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "identify/fit/local_fit.hpp"
#include "identify/noise/force_noise.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr double kJointPeakToResidual = 3;  // a mode's peak over the rms residual around it
constexpr double kJointMaxDamping = 0.98 * kMaxDampingRatio;
constexpr double kJointCoincide = 0.05;   // bandwidths between two poles that the fit has merged
constexpr double kJointWindowWidths = 5;  // half-power bandwidths on either side of a mode
constexpr double kJointWindowLines = 8;
constexpr double kMaterialResidual = 2e-3;  // of the FRF: less moves no mode by more than 2e-3 bandwidths
constexpr double kGainNoise = 4;            // standard deviations of the gain error from the force's noise
constexpr double kMinNoiseShare = 0.02;     // least part of the lines that counts as independent
constexpr double kModeGain = 150;  // likelihood_ratio_statistic() that a mode needs, divided among its unknowns
// Limits of this gain per unknown. The maximum is the F statistic that a close mode needs, the minimum about the
// logarithm of the number of lines.
constexpr double kMaxGain = 25, kMinGain = 8;
// Limits for a clear mode. kClearGain, per unknown, is small, because only a few lines around the mode are independent:
// with the eight unknowns of three FRFs, noise reaches it once in 10⁴ cases.
constexpr double kClearSignificance = 2 * kJointSignificance, kClearPeakToResidual = 10, kClearWidths = 1;
constexpr double kClearGain = 4;
// With a gain above kStrongGain, kStrongPeakToResidual suffices: the misfit of other modes may raise the residual.
constexpr double kStrongGain = kMaxGain, kStrongPeakToResidual = 5;

// The part of a residual that is rough from line to line: 1 for noise, little for the misfit of a model.
double noise_part(const VectorXcd& residual) {
  const Index inner = residual.size() - 2;
  if (inner < 1 || !(residual.squaredNorm() > 0)) return 1;
  const double rough = (residual.segment(1, inner) - 0.5 * (residual.head(inner) + residual.tail(inner))).squaredNorm();
  return std::clamp(rough / (kWhiteRoughness * residual.segment(1, inner).squaredNorm()), kMinNoiseShare, 1.0);
}

// [channels] energy of a residual over the noise.
std::vector<double> energies_of(const FrfDataset& set, const std::vector<VectorXcd>& residual) {
  const LineNoise noise(set);
  std::vector<double> energy(residual.size());
  for (std::size_t o = 0; o < residual.size(); ++o) {
    const std::vector<double> power = noise.local(o);
    for (std::size_t k = 0; k < power.size(); ++k)
      if (power[k] > 0) energy[o] += std::norm(residual[o](static_cast<Index>(k))) / power[k];
  }
  return energy;
}

bool is_mode(const FrfDataset& set, const JointFit& fit, std::size_t mode, const ModeSignificance& of_mode) {
  const Pole& pole = fit.poles[mode];
  const auto m = static_cast<Index>(mode);
  const bool inside = pole.freq_Hz > set.lines.freq_Hz(0) && pole.freq_Hz < set.lines.freq_Hz(set.lines.count - 1);
  return inside && pole.damping_ratio < kJointMaxDamping && fit.damping_std(m) < pole.damping_ratio &&
         fit.freq_std_Hz(m) < resolved_width_Hz(pole, set.lines) && of_mode.significance > kJointSignificance &&
         of_mode.peak_to_residual > kJointPeakToResidual;
}

// As likelihood_ratio_statistic(), over the lines around a pole, where the level of the residual is about constant.
double local_likelihood_ratio_statistic(const FrfDataset& set, const std::vector<VectorXcd>& before,
                                        const std::vector<VectorXcd>& after, const Pole& pole) {
  const JointWindow window = joint_window(set, pole);
  double ratio = 0;
  for (std::size_t o = 0; o < after.size(); ++o) {
    const VectorXcd left = after[o].segment(window.first, window.count);
    const double more = before[o].segment(window.first, window.count).squaredNorm(), less = left.squaredNorm();
    if (more > 0 && less > 0) ratio += 2 * static_cast<double>(window.count) * noise_part(left) * std::log(more / less);
  }
  return ratio;
}

// True where no other mode of the fit lies near, and the pole is not the one that a known mode became.
bool stands_alone(const FrfDataset& set, const std::vector<Pole>& known, const std::vector<Pole>& poles,
                  const Pole& pole) {
  const auto distance_Hz = [](const Pole& a, const Pole& b) { return std::abs(a.freq_Hz - b.freq_Hz); };
  const auto became = [&](const Pole& one) {
    return std::none_of(poles.begin(), poles.end(), [&](const Pole& other) {
      return &other != &pole && distance_Hz(one, other) < distance_Hz(one, pole);
    });
  };
  const auto near = [&](const Pole& other) {
    const double width_Hz = std::max(resolved_width_Hz(pole, set.lines), resolved_width_Hz(other, set.lines));
    return &other != &pole && distance_Hz(pole, other) <= kClearWidths * width_Hz;
  };
  return std::none_of(known.begin(), known.end(), became) && std::none_of(poles.begin(), poles.end(), near);
}

bool is_clear(const FrfDataset& set, const KnownModes& known, const JointFit& fit, std::size_t mode) {
  const Pole& pole = fit.poles[mode];
  if (!stands_alone(set, known.poles, fit.poles, pole)) return false;
  const ModeSignificance of_mode = significance_of(set, fit, mode, Misfit::counted);
  if (!(of_mode.significance > kClearSignificance && of_mode.peak_to_residual > kStrongPeakToResidual)) return false;
  const double gain = local_likelihood_ratio_statistic(set, known.residual, fit.residual, pole) /
                      static_cast<double>(unknowns_per_mode(set));
  return gain > (of_mode.peak_to_residual > kClearPeakToResidual ? kClearGain : kStrongGain);
}

// [channels] the residual's lines in a window.
std::vector<VectorXcd> residual_in(const std::vector<VectorXcd>& residual, const JointWindow& window, Tails tails) {
  std::vector<VectorXcd> out;
  out.reserve(residual.size());
  for (const VectorXcd& of_frf : residual) out.emplace_back(of_frf.segment(window.first, window.count));
  if (tails == Tails::removed) {
    const auto terms = static_cast<Index>(LocalFitOptions{}.residual_terms);
    const Eigen::MatrixXcd smooth = orthonormal_polynomials(window.count, terms).cast<Complex>();
    for (VectorXcd& left : out) left -= smooth * (smooth.adjoint() * left);
  }
  return out;
}

}  // namespace

JointWindow joint_window(const FrfDataset& set, const Pole& pole) {
  const double half = std::max(kJointWindowWidths * pole.half_power_Hz() / set.lines.df_Hz(), kJointWindowLines);
  const double at = set.lines.position(pole.freq_Hz);
  const auto first = static_cast<Index>(set.lines.at(at - half));
  return {.first = first, .count = static_cast<Index>(set.lines.at(at + half)) - first + 1};
}

bool are_merged(const FrfDataset& set, const Pole& a, const Pole& b) {
  const double narrower_Hz = std::min(resolved_width_Hz(a, set.lines), resolved_width_Hz(b, set.lines));
  return std::abs(a.freq_Hz - b.freq_Hz) < kJointCoincide * narrower_Hz;
}

ModeSignificance significance_of(const FrfDataset& set, const JointFit& fit, std::size_t mode, Misfit misfit) {
  const Pole& pole = fit.poles[mode];
  const JointWindow window = joint_window(set, pole);
  const double width = std::max(2 * pole.damping_ratio, set.lines.df_Hz() / pole.freq_Hz);
  ModeSignificance best;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const VectorXcd left = fit.residual[o].segment(window.first, window.count);
    const double size = std::abs(fit.residues(static_cast<Index>(o), static_cast<Index>(mode)));
    const double std = fit.residue_std(static_cast<Index>(o), static_cast<Index>(mode));
    const double rms = left.norm() / std::sqrt(static_cast<double>(window.count));
    const double part = misfit == Misfit::counted ? noise_part(left) : 1;
    if (std > 0) best.significance = std::max(best.significance, size / std * std::sqrt(part));
    if (rms > 0) best.peak_to_residual = std::max(best.peak_to_residual, size / width / rms);
  }
  return best;
}

std::vector<Pole> without_weakest(const FrfDataset& set, const JointFit& fit, Misfit misfit) {
  const std::size_t count = fit.poles.size();
  std::vector<double> significance(count);
  std::vector<char> accepted(count);
  for (std::size_t m = 0; m < count; ++m) {
    const ModeSignificance of_mode = significance_of(set, fit, m, misfit);
    significance[m] = of_mode.significance;
    accepted[m] = is_mode(set, fit, m, of_mode);
    for (std::size_t i = 0; i < m; ++i)
      if (are_merged(set, fit.poles[i], fit.poles[m])) accepted[m] = 0;
  }
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < count; ++m) {
    const auto weaker_beside = [&](std::size_t i) {
      const double apart_Hz = std::abs(fit.poles[i].freq_Hz - fit.poles[m].freq_Hz);
      const bool near = apart_Hz < 2 * std::max(resolved_width_Hz(fit.poles[i], set.lines),
                                                resolved_width_Hz(fit.poles[m], set.lines));
      return i != m && !accepted[i] && near &&
             (significance[i] < significance[m] || (significance[i] == significance[m] && i < m));
    };
    bool keep = accepted[m];
    for (std::size_t i = 0; i < count && !keep; ++i) keep = weaker_beside(i);
    if (keep) kept.push_back(fit.poles[m]);
  }
  return kept;
}

double misfit_of(const FrfDataset& set, const std::vector<VectorXcd>& residual, const Pole& pole, Tails tails) {
  const JointWindow window = joint_window(set, pole);
  double worst = 0;
  for (const VectorXcd& left : residual_in(residual, window, tails))
    worst = std::max(worst, (1 - noise_part(left)) * std::sqrt(static_cast<double>(window.count)));
  return worst;
}

bool is_material(const FrfDataset& set, const std::vector<VectorXcd>& residual, const Pole& pole, Tails tails) {
  const JointWindow window = joint_window(set, pole);
  const std::vector<VectorXcd> left = residual_in(residual, window, tails);
  for (std::size_t o = 0; o < residual.size(); ++o) {
    const Eigen::Map<const VectorXcd> frf(set.channels[o].frf.data(), residual[o].size());
    const double of_force = kGainNoise * gain_std(set, set.channels[o].point, pole.freq_Hz);
    if (left[o].norm() > std::max(kMaterialResidual, of_force) * frf.segment(window.first, window.count).norm())
      return true;
  }
  return false;
}

double likelihood_ratio_statistic(const FrfDataset& set, const std::vector<VectorXcd>& before,
                                  const std::vector<VectorXcd>& after) {
  const std::vector<double> more = energies_of(set, before), less = energies_of(set, after);
  double ratio = 0;
  for (std::size_t o = 0; o < more.size(); ++o) {
    if (!(more[o] > 0) || !(less[o] > 0)) continue;
    ratio += 2 * static_cast<double>(after[o].size()) * noise_part(after[o]) * std::log(more[o] / less[o]);
  }
  return ratio;
}

std::size_t unknowns_per_mode(const FrfDataset& set) { return 2 + 2 * set.channels.size(); }

double min_gain(const FrfDataset& set, std::size_t unknowns) {
  const double each = std::clamp(kModeGain / static_cast<double>(unknowns_per_mode(set)), kMinGain, kMaxGain);
  return each * static_cast<double>(unknowns);
}

std::vector<Pole> clear_modes(const FrfDataset& set, const KnownModes& known, const JointFit& fit) {
  std::vector<Pole> clear;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    if (is_clear(set, known, fit, m)) clear.push_back(fit.poles[m]);
  }
  return clear;
}

double min_gain_beside(const FrfDataset& set, std::size_t unknowns, std::size_t clear) {
  const std::size_t of_clear = clear * unknowns_per_mode(set);
  return unknowns > of_clear ? min_gain(set, unknowns - of_clear) : 0;
}

}  // namespace percuss::identify
