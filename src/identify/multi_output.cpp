#include "identify/multi_output.hpp"

#include <algorithm>

#include "core/parallel/parallel.hpp"
#include "identify/fit/completed_decays.hpp"
#include "identify/fit/joint_fit.hpp"
#include "identify/fit/principal_frfs.hpp"
#include "identify/fit/windowed_fit.hpp"
#include "identify/noise/force_noise.hpp"
#include "identify/noise/line_noise.hpp"
#include "identify/select/frequency_scatter.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMaxRemainingAmplitude = 0.05;  // largest amplitude of a mode at the records' end
constexpr double kMaxResidualEnergy = 1.5;       // around a mode, over its expectation for noise
constexpr double kCheckedWidths = 5;             // half-power bandwidths on either side of a checked pole
constexpr double kMinCheckedLines = 10;          // on either side
constexpr std::size_t kMinFlops = 1'000'000;     // operations per task, a lower limit
constexpr std::size_t kFlopsPerLine = 60;        // operations of the gain errors or of the residual energy

double max_remaining_amplitude(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  double most = 0;
  for (const FittedMode& mode : modes) most = std::max(most, remaining_amplitude(mode.mode.pole, set.lines));
  return most;
}

// True where some close pair only describes the frequency scatter of one mode.
bool any_pair_is_scatter(const FrfDataset& set, const std::vector<Pole>& poles) {
  WindowedFit all(set);
  all.replace(poles);
  const auto pair = [](const FitGroup& group) { return group.fit.poles.size() > 1; };
  if (std::none_of(all.groups().begin(), all.groups().end(), pair)) return false;
  all.sweep();
  return std::any_of(all.groups().begin(), all.groups().end(),
                     [&](const FitGroup& group) { return pair(group) && merge_if_scattered(all, group); });
}

Eigen::MatrixXd covariance_of(const std::vector<FittedMode>& modes) {
  const auto unknowns = static_cast<Index>(2 * modes.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (Index m = 0; m < unknowns / 2; ++m) {
    const Mode& mode = modes[static_cast<std::size_t>(m)].mode;
    covariance(2 * m, 2 * m) = mode.freq_std_Hz * mode.freq_std_Hz;
    covariance(2 * m + 1, 2 * m + 1) = mode.damping_std * mode.damping_std;
  }
  return covariance;
}

// Adds the missing decays to all FRFs, recomputes their principal components `principal`, and fits `found` to these.
// Each pass multiplies the error by the remaining truncation.
void complete(CompletedDecays& completed, const Eigen::MatrixXd& components, FrfDataset& principal,
              std::vector<FittedMode>& found) {
  double truncation = max_remaining_amplitude(principal, found);
  while (truncation > kMinTruncation) {
    const std::vector<Pole> poles = poles_of(found);
    completed.add_missing_decays(poles, residues_at(completed.set(), poles));
    principal = principal_frfs(completed.set(), components);
    found = fit_sequentially(principal, {.start = poles});
    truncation *= max_remaining_amplitude(principal, found);
  }
}

// [lines] variance of the difference between the force's gain error at each line and at the pole. The residue absorbs
// the error at the pole.
Eigen::VectorXd gain_variance(const FrfDataset& set, std::size_t point, Index from, Index to, std::size_t pole) {
  std::vector<std::size_t> lines{pole};
  for (Index k = from; k <= to; ++k) lines.push_back(static_cast<std::size_t>(k));
  const Eigen::MatrixXcd errors = gain_errors(set, point, lines);
  if (errors.size() == 0) return Eigen::VectorXd::Zero(to - from + 1);
  return (errors.bottomRows(to - from + 1).rowwise() - errors.row(0)).rowwise().squaredNorm();
}

struct PoleWindow {
  Index from = 0, to = 0;  // lines, both included
  std::size_t pole = 0;    // line
};

// The residual energy of an FRF around a pole over its noise, and its expectation for pure noise.
struct ResidualEnergy {
  double energy = 0, expected = 0;
};

std::vector<ResidualEnergy> residual_energy_near(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual,
                                                 const LineNoise& noise, const PoleWindow& window) {
  std::vector<Eigen::VectorXd> gain(set.points.size());
  const auto lines = static_cast<std::size_t>(window.to - window.from + 1);
  parallel_for_cost(gain.size(), kFlopsPerLine * lines,
                    [&](std::size_t p) { gain[p] = gain_variance(set, p, window.from, window.to, window.pole); });
  std::vector<ResidualEnergy> out(set.channels.size());
  parallel_for_cost(out.size(), kFlopsPerLine * lines, [&](std::size_t o) {
    const FrfChannel& channel = set.channels[o];
    for (Index k = window.from; k <= window.to; ++k) {
      const auto line = static_cast<std::size_t>(k);
      const double n = noise.at(o, line);
      out[o].energy += std::norm(residual[o](k)) / (n * n);
      out[o].expected += 1 + gain[channel.point](k - window.from) * std::norm(channel.frf[line]) / (n * n);
    }
  });
  return out;
}

// True where the residual around every mode is only noise, of the responses and of the force.
bool fits_to_noise(const FrfDataset& set, const JointFit& fit) {
  const LineNoise noise(set);
  for (const Pole& pole : fit.poles) {
    const double at = set.lines.position(pole.freq_Hz);
    const double half = std::max(kCheckedWidths * pole.half_power_Hz() / set.lines.df_Hz(), kMinCheckedLines);
    const auto from = static_cast<Index>(set.lines.at(at - half));
    const auto to = static_cast<Index>(set.lines.at(at + half));
    const std::vector<ResidualEnergy> of_channel =
        residual_energy_near(set, fit.residual, noise, {.from = from, .to = to, .pole = set.lines.at(at)});
    double energy = 0, expected = 0;
    for (const ResidualEnergy& one : of_channel) {
      energy += one.energy;
      expected += one.expected;
    }
    if (energy > kMaxResidualEnergy * expected) return false;
  }
  return true;
}

std::vector<Mode> modes_of(const FrfDataset& set, const std::vector<FittedMode>& found, const JointFit& fit) {
  std::vector<Mode> modes;
  for (std::size_t m = 0; m < found.size(); ++m) {
    Mode mode = found[m].mode;
    mode.residues.clear();
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      mode.residues.push_back({.point = set.channels[o].point,
                               .channel = set.channels[o].channel,
                               .value = fit.residues(static_cast<Index>(o), static_cast<Index>(m)),
                               .std = fit.residue_std(static_cast<Index>(o), static_cast<Index>(m)),
                               .relative_std = gain_amplitude_std(set, set.channels[o].point, mode.pole.freq_Hz)});
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace

std::optional<std::vector<Mode>> identify_multi_output(const FrfDataset& set, const IdentifyOptions& options) {
  // The model of an exponential window needs the pulses, which principal-component FRFs do not have.
  if (set.window_decay_per_s() != 0) return std::nullopt;
  const Eigen::MatrixXd components = principal_components(set, kMaxPrincipalFrfs);
  FrfDataset principal = principal_frfs(set, components);
  CompletedDecays completed(set);
  std::vector<FittedMode> found;
  // The strong modes first: their truncation would look like additional modes.
  const SequentialFitOptions thorough = sequential_fit_options(options.effort);
  for (const SequentialFitOptions& pass : {SequentialFitOptions{.max_rounds = 0}, thorough}) {
    const std::size_t before = found.size();
    found = fit_sequentially(principal, pass);
    if (found.empty() || max_remaining_amplitude(set, found) > kMaxRemainingAmplitude) return std::nullopt;
    if (found.size() != before && CompletedDecays::truncation_is_known(set))
      complete(completed, components, principal, found);
  }
  const std::vector<Pole> poles = poles_of(found);
  bool scatters = false;  // any_pair_is_scatter seldom holds, so the refinement runs beside it
  parallel_for_cost(2, kMinFlops, [&](std::size_t task) {
    if (task == 0) scatters = any_pair_is_scatter(completed.set(), poles);
    if (task == 1 && options.effort == Effort::best) refine_jointly(principal, found);
  });
  if (scatters) return std::nullopt;
  const JointFit fit = fit_residues(completed.set(), poles_of(found), covariance_of(found));
  if (!fits_to_noise(completed.set(), fit)) return std::nullopt;
  return modes_of(completed.set(), found, fit);
}

}  // namespace percuss::identify
