#include "identify/select/joint_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "identify/fit/joint_fit.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/noise/window_noise.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/stable_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

constexpr double kJointSignificance = 6;    // standard deviations of a residue
constexpr double kJointPeakToResidual = 3;  // a mode's peak over the rms residual around it
constexpr double kJointGain = 25;           // likelihood ratio per unknown, as for a close mode
constexpr double kJointMaxDamping = 0.98 * kMaxDampingRatio;
constexpr double kJointCoincide = 0.05;    // bandwidths between two poles that the fit has merged
constexpr double kJointWindowWidths = 5;   // half-power bandwidths on either side of a mode
constexpr double kJointWindowLines = 8;
constexpr int kDroppingRounds = 12;        // of dropping modes
constexpr int kJointSteps = 40;         // of a joint fit
constexpr std::size_t kMaxJointModes = 150;
constexpr double kScatterReach = 4;    // standard deviations of a frequency's scatter between the poles of a pair
constexpr double kPairGain = 15;   // residual energy of separate poles over a pair's: below it, the mode moves
constexpr double kMinMisfit = 6;       // standard deviations of the residual's roughness
constexpr double kPairStart = 0.4;     // half-power bandwidths from a mode to either of the pair that it may be
constexpr std::size_t kMaxPairTrials = 6, kMaxWeakTrials = 3;  // at a time
constexpr std::size_t kMaxTrials = 27;                         // of one more mode
constexpr double kMinNoiseShare = 0.02;  // of the lines: an estimate of the independent ones, at least

double least_width_Hz(const FrfDataset& set, const Pole& pole) {
  return std::max(pole.half_power_Hz(), 0.5 * set.lines.df_Hz());
}

struct JointWindow {
  Index first = 0, count = 0;
};

JointWindow window_around(const FrfDataset& set, const Pole& pole) {
  const double half = std::max(kJointWindowWidths * pole.half_power_Hz() / set.lines.df_Hz(), kJointWindowLines);
  const double at = set.lines.position(pole.freq_Hz);
  const auto first = static_cast<Index>(set.lines.at(at - half));
  return {.first = first, .count = static_cast<Index>(set.lines.at(at + half)) - first + 1};
}

// The part of a residual that is rough from line to line: 1 for noise, little for the misfit of a model.
double noise_part(const VectorXcd& residual) {
  const Index inner = residual.size() - 2;
  if (inner < 1 || !(residual.squaredNorm() > 0)) return 1;
  const double rough = (residual.segment(1, inner) - 0.5 * (residual.head(inner) + residual.tail(inner))).squaredNorm();
  return std::clamp(rough / (kWhiteRoughness * residual.segment(1, inner).squaredNorm()), kMinNoiseShare, 1.0);
}

// A mode of a joint fit: how far it stands out of what the fit left around it.
struct Standing {
  double significance = 0;      // of its clearest residue, in standard deviations
  double peak_to_residual = 0;  // largest over the FRFs
};

Standing standing_of(const FrfDataset& set, const JointFit& fit, std::size_t mode) {
  const Pole& pole = fit.poles[mode];
  const JointWindow window = window_around(set, pole);
  const double peak = std::max(2 * pole.damping_ratio, set.lines.df_Hz() / pole.freq_Hz);
  Standing best;
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    const VectorXcd left = fit.residual[o].segment(window.first, window.count);
    const double size = std::abs(fit.residues(static_cast<Index>(o), static_cast<Index>(mode)));
    const double std = fit.residue_std(static_cast<Index>(o), static_cast<Index>(mode));
    const double rms = left.norm() / std::sqrt(static_cast<double>(window.count));
    if (std > 0) best.significance = std::max(best.significance, size / std * std::sqrt(noise_part(left)));
    if (rms > 0) best.peak_to_residual = std::max(best.peak_to_residual, size / peak / rms);
  }
  return best;
}

bool is_mode(const FrfDataset& set, const JointFit& fit, std::size_t mode, const Standing& standing) {
  const Pole& pole = fit.poles[mode];
  const auto m = static_cast<Index>(mode);
  const bool inside = pole.freq_Hz > set.lines.freq_Hz(0) && pole.freq_Hz < set.lines.freq_Hz(set.lines.count - 1);
  return inside && pole.damping_ratio < kJointMaxDamping && fit.damping_std(m) < pole.damping_ratio &&
         fit.freq_std_Hz(m) < least_width_Hz(set, pole) && standing.significance > kJointSignificance &&
         standing.peak_to_residual > kJointPeakToResidual;
}

// The poles without those that are no modes. Of neighbours only the weakest goes: without it, the others may stand.
std::vector<Pole> without_weakest(const FrfDataset& set, const JointFit& fit) {
  const std::size_t count = fit.poles.size();
  std::vector<double> significance(count);
  std::vector<char> accepted(count);
  for (std::size_t m = 0; m < count; ++m) {
    const Standing standing = standing_of(set, fit, m);
    significance[m] = standing.significance;
    accepted[m] = is_mode(set, fit, m, standing);
    for (std::size_t i = 0; i < m; ++i) {
      const double apart_Hz = std::abs(fit.poles[i].freq_Hz - fit.poles[m].freq_Hz);
      if (apart_Hz < kJointCoincide * std::min(least_width_Hz(set, fit.poles[i]), least_width_Hz(set, fit.poles[m]))) accepted[m] = 0;
    }
  }
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < count; ++m) {
    const auto weaker_beside = [&](std::size_t i) {
      const double apart_Hz = std::abs(fit.poles[i].freq_Hz - fit.poles[m].freq_Hz);
      const bool near = apart_Hz < 2 * std::max(least_width_Hz(set, fit.poles[i]), least_width_Hz(set, fit.poles[m]));
      return i != m && !accepted[i] && near && (significance[i] < significance[m] || (significance[i] == significance[m] && i < m));
    };
    bool keep = accepted[m];
    for (std::size_t i = 0; i < count && !keep; ++i) keep = weaker_beside(i);
    if (keep) kept.push_back(fit.poles[m]);
  }
  return kept;
}

// The joint fit from these poles, insignificant ones dropped; nothing where it does not settle.
std::optional<JointFit> settled_fit(const FrfDataset& set, std::vector<Pole> poles) {
  for (int round = 0; round < kDroppingRounds && !poles.empty(); ++round) {
    JointFit fit = fit_jointly(set, poles, {.max_steps = kJointSteps});
    const bool converged = fit.converged;
    const auto unknowns = static_cast<Index>(2 * fit.poles.size());
    if (fit.residual.empty()) fit = fit_residues(set, fit.poles, MatrixXd::Zero(unknowns, unknowns));
    poles = without_weakest(set, fit);
    if (converged && poles.size() == fit.poles.size()) return fit;
  }
  return std::nullopt;
}

std::vector<Pole> start_poles(const std::vector<FittedMode>& modes) {
  std::vector<Pole> poles;
  for (const FittedMode& mode : modes) poles.push_back(mode.mode.pole);
  return poles;
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

// The residual of the modes found first: of the joint model, or of the windows where a mode has its own pole per point.
std::vector<VectorXcd> residual_before(const FrfDataset& set, const std::vector<FittedMode>& modes,
                                       std::vector<VectorXcd> residual) {
  if (residual.empty()) {
    const auto unknowns = static_cast<Index>(2 * modes.size());
    residual = fit_residues(set, start_poles(modes), MatrixXd::Zero(unknowns, unknowns)).residual;
  }
  for (const FittedMode& mode : modes) {
    if (!(mode.mode.freq_scatter_Hz > 0)) continue;
    for (std::size_t o = 0; o < residual.size(); ++o) {
      auto window = residual[o].segment(static_cast<Index>(mode.first), static_cast<Index>(mode.count));
      const double rms = window.norm() / std::sqrt(static_cast<double>(mode.count));
      const double own = mode.noise(static_cast<Index>(o));
      if (own < rms) window *= own / rms;
    }
  }
  return residual;
}

std::size_t unknowns_of(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  std::size_t unknowns = modes.size() * (2 + 2 * set.channels.size());
  for (const FittedMode& mode : modes) {
    if (mode.mode.freq_scatter_Hz > 0) unknowns += 2 * (set.points.size() - 1);
  }
  return unknowns;
}

// Likelihood ratio of two residuals, with as many degrees of freedom as the better one has independent lines.
double likelihood_ratio(const FrfDataset& set, const std::vector<VectorXcd>& before,
                        const std::vector<VectorXcd>& after) {
  const std::vector<double> more = energies_of(set, before), less = energies_of(set, after);
  double ratio = 0;
  for (std::size_t o = 0; o < more.size(); ++o) {
    if (!(more[o] > 0) || !(less[o] > 0)) continue;
    ratio += 2 * static_cast<double>(after[o].size()) * noise_part(after[o]) * std::log(more[o] / less[o]);
  }
  return ratio;
}

// True where a pair of the new modes may only describe the scatter of one mode's frequency. A drift during the decay
// then makes the pair fit somewhat better than separate poles.
bool pair_is_scatter(const FrfDataset& set, const std::vector<FittedMode>& modes, const JointFit& fit) {
  return std::any_of(modes.begin(), modes.end(), [&](const FittedMode& mode) {
    if (!(mode.mode.freq_scatter_Hz > 0)) return false;
    const double reach_Hz = std::max(kScatterReach * mode.mode.freq_scatter_Hz, least_width_Hz(set, mode.mode.pole));
    std::vector<double> near;
    for (const Pole& pole : fit.poles) {
      if (std::abs(pole.freq_Hz - mode.mode.pole.freq_Hz) < reach_Hz) near.push_back(pole.freq_Hz);
    }
    if (near.size() < 2) return false;
    const auto [low, high] = std::minmax_element(near.begin(), near.end());
    double separate = 0, pair = 0;
    for (std::size_t o = 0; o < fit.residual.size(); ++o) {
      const double n = mode.noise(static_cast<Index>(o));
      separate += n * n * static_cast<double>(mode.count);
      pair += fit.residual[o].segment(static_cast<Index>(mode.first), static_cast<Index>(mode.count)).squaredNorm();
    }
    return *high - *low < reach_Hz && separate < kPairGain * pair;
  });
}

// The starts: every stable pole, and the modes found before that none of them stands for.
std::vector<Pole> starts_of(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = stable_poles(set);
  for (const Pole& known : start_poles(modes)) {
    const auto near = [&](const Pole& pole) {
      return std::abs(pole.freq_Hz - known.freq_Hz) < 0.5 * least_width_Hz(set, known) && same_place(pole, known);
    };
    std::erase_if(starts, near);
    starts.push_back(known);
  }
  return starts;
}

std::vector<FittedMode> joint_modes(const FrfDataset& set, const JointFit& fit) {
  std::vector<FittedMode> modes;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    const JointWindow window = window_around(set, fit.poles[m]);
    FittedMode& mode = modes.emplace_back();
    mode.first = static_cast<std::size_t>(window.first);
    mode.count = static_cast<std::size_t>(window.count);
    mode.peak_to_residual = standing_of(set, fit, m).peak_to_residual;
    mode.noise.resize(static_cast<Index>(set.channels.size()));
    for (std::size_t o = 0; o < set.channels.size(); ++o)
      mode.noise(static_cast<Index>(o)) = fit.residual[o].segment(window.first, window.count).norm() /
                                          std::sqrt(static_cast<double>(window.count));
    take_joint_mode(set, fit, m, mode);
  }
  std::sort(modes.begin(), modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
  return modes;
}

// How far the residual around a mode is from noise, in standard deviations of its roughness; the worst FRF.
double misfit_of(const FrfDataset& set, const std::vector<VectorXcd>& residual, const Pole& pole) {
  const JointWindow window = window_around(set, pole);
  double worst = 0;
  for (std::size_t o = 0; o < residual.size(); ++o) {
    const double part = noise_part(residual[o].segment(window.first, window.count));
    worst = std::max(worst, (1 - part) * std::sqrt(static_cast<double>(window.count)));
  }
  return worst;
}

bool must_search(const FrfDataset& set, const std::vector<VectorXcd>& residual, const std::vector<FittedMode>& modes) {
  const auto alone = [](const FittedMode& mode) { return !mode.joint || mode.mode.freq_scatter_Hz > 0; };
  const auto misfits = [&](const FittedMode& mode) {
    return misfit_of(set, residual, mode.mode.pole) > kMinMisfit;
  };
  return residual.empty() || std::any_of(modes.begin(), modes.end(), alone) ||
         std::any_of(modes.begin(), modes.end(), misfits) || !residual_resonances(set, residual).empty();
}

// The poles with one more: each misfitting mode as a close pair, and the clearest resonances of the residual.
std::vector<std::vector<Pole>> with_one_more(const FrfDataset& set, const JointFit& fit) {
  std::vector<std::pair<double, std::size_t>> misfits;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    const double misfit = misfit_of(set, fit.residual, fit.poles[m]);
    if (misfit > kMinMisfit) misfits.emplace_back(misfit, m);
  }
  std::sort(misfits.rbegin(), misfits.rend());
  misfits.resize(std::min(misfits.size(), kMaxPairTrials));
  std::vector<std::vector<Pole>> trials;
  for (const auto& [misfit, m] : misfits) {
    Pole beside = fit.poles[m];
    beside.freq_Hz += kPairStart * beside.half_power_Hz();
    trials.push_back(fit.poles);
    trials.back()[m].freq_Hz -= kPairStart * beside.half_power_Hz();
    trials.back().push_back(beside);
  }
  std::vector<Pole> weak = residual_mode_poles(set, fit.residual);
  weak.resize(std::min(weak.size(), kMaxWeakTrials));
  for (const Pole& pole : weak) {
    trials.push_back(fit.poles);
    trials.back().push_back(pole);
  }
  return trials;
}

// Adds modes one by one, as long as the likelihood gains.
JointFit grown(const FrfDataset& set, JointFit fit) {
  const double least = kJointGain * static_cast<double>(2 + 2 * set.channels.size());
  std::size_t tried = 0;
  for (bool gained = true; gained && tried < kMaxTrials;) {
    gained = false;
    JointFit best;
    double most = least;
    for (std::vector<Pole>& poles : with_one_more(set, fit)) {
      ++tried;
      JointFit trial = fit_jointly(set, std::move(poles), {.max_steps = kJointSteps});
      if (!trial.converged || without_weakest(set, trial).size() != trial.poles.size()) continue;
      const double ratio = likelihood_ratio(set, fit.residual, trial.residual);
      if (ratio <= most) continue;
      most = ratio;
      best = std::move(trial);
      gained = true;
    }
    if (gained) fit = std::move(best);
  }
  return fit;
}

// The better of the joint fits from the modes found before and from the stable poles.
std::optional<JointFit> best_fit(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = starts_of(set, modes);
  if (starts.empty() || starts.size() > kMaxJointModes) return std::nullopt;
  const std::size_t known = modes.size();
  const bool more = starts.size() > known;
  std::optional<JointFit> before = settled_fit(set, start_poles(modes));
  std::optional<JointFit> after = more ? settled_fit(set, std::move(starts)) : std::nullopt;
  if (!before || !after) return after ? std::move(after) : std::move(before);
  const double per_mode = kJointGain * static_cast<double>(2 + 2 * set.channels.size());
  const double added = static_cast<double>(after->poles.size()) - static_cast<double>(before->poles.size());
  const double gain = likelihood_ratio(set, before->residual, after->residual);
  return gain > per_mode * added ? std::move(after) : std::move(before);
}

}  // namespace

void search_jointly(const FrfDataset& set, const std::vector<VectorXcd>& residual, std::vector<FittedMode>& modes) {
  if (!must_search(set, residual, modes)) return;
  std::optional<JointFit> fit = best_fit(set, modes);
  if (!fit) return;
  fit = grown(set, *std::move(fit));
  const std::size_t before = unknowns_of(set, modes), after = fit->poles.size() * (2 + 2 * set.channels.size());
  const double least = kJointGain * static_cast<double>(after > before ? after - before : 2 + 2 * set.channels.size());
  if (likelihood_ratio(set, residual_before(set, modes, residual), fit->residual) < least) return;
  if (pair_is_scatter(set, modes, *fit)) return;
  modes = joint_modes(set, *fit);
}

}  // namespace percuss::identify
