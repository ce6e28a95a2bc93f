#include "identify/multi_output.hpp"

#include <algorithm>

#include "core/parallel/parallel.hpp"
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

constexpr double kMaxRemainingAmplitude = 0.05;  // of a mode's amplitude at a record's end
constexpr double kCompleted = 1e-9;              // what is missing counts no more
constexpr double kExplained = 1.5;               // energy around a mode over what noise explains
constexpr double kCheckedWidths = 5;             // half-power bandwidths
constexpr double kMinCheckedLines = 10;          // lines
constexpr std::size_t kMinFlops = 1'000'000;     // operations, at the least
constexpr std::size_t kFlopsPerLine = 60;  // operations of what costs most: what is missing of a decay, a gain's errors

double max_remaining_amplitude(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  double most = 0;
  for (const FittedMode& mode : modes) most = std::max(most, remaining_amplitude(mode.mode.pole, set.lines));
  return most;
}

// Of a close pair it must be asked whether it only stands for one mode that moves from point to point.
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

std::vector<Pole> poles_of(const std::vector<FittedMode>& modes) {
  std::vector<Pole> poles;
  poles.reserve(modes.size());
  for (const FittedMode& mode : modes) poles.push_back(mode.mode.pole);
  return poles;
}

// The set as records would have given it that hold the whole decay.
class CompletedDecays {
 public:
  explicit CompletedDecays(const FrfDataset& cut)
      : cut_(cut), whole_{.lines = cut.lines, .usable_bandwidth_Hz = cut.usable_bandwidth_Hz} {
    whole_.points.resize(cut.points.size());
    parallel_for_cost(cut.points.size(), kFlopsPerProduct * cut.lines.count, [&](std::size_t p) {
      const PointForce& point = cut.points[p];
      whole_.points[p] = {.blocks = point.blocks, .spectra = {}, .ff = point.ff, .noise_N = point.noise_N};
      whole_.points[p].complete = true;
    });
    whole_.channels.resize(cut.channels.size());
    parallel_for_cost(cut.channels.size(), kFlopsPerProduct * cut.lines.count,
                      [&](std::size_t o) { whole_.channels[o] = cut.channels[o]; });
  }
  const FrfDataset& set() const { return whole_; }
  // FRFs that came without records do not tell what is missing of them.
  bool from_records() const {
    return std::all_of(cut_.points.begin(), cut_.points.end(), [](const PointForce& p) { return !p.blocks.empty(); });
  }

  // Residues fitted to a set less complete are off by as much as that lacks; what is added, by as much again.
  void add_missing_decays(const std::vector<Pole>& poles, const Eigen::MatrixXcd& residues) {
    parallel_for_cost(cut_.channels.size(), kFlopsPerProduct * cut_.lines.count,
                      [&](std::size_t o) { whole_.channels[o].frf = cut_.channels[o].frf; });
    for (std::size_t m = 0; m < poles.size(); ++m) {
      if (remaining_amplitude(poles[m], cut_.lines) < kCompleted) continue;
      const TruncatedDecay missing(poles[m], 0, cut_.lines, 0, cut_.lines.count);
      parallel_for_cost(cut_.channels.size(), kFlopsPerLine * cut_.lines.count, [&](std::size_t o) {
        missing.add_to(whole_.channels[o].frf, residues(static_cast<Index>(o), static_cast<Index>(m)),
                       cut_.points[cut_.channels[o].point]);
      });
    }
  }

 private:
  const FrfDataset& cut_;
  FrfDataset whole_;
};

// Turns `few` into the channels of complete records, and fits `found` to them. Each time what is missing is known
// better, by as much as is missing.
void complete(CompletedDecays& completed, const Eigen::MatrixXd& sums, FrfDataset& few,
              std::vector<FittedMode>& found) {
  double left = max_remaining_amplitude(few, found);
  while (left > kCompleted) {
    const std::vector<Pole> poles = poles_of(found);
    completed.add_missing_decays(poles, residues_at(completed.set(), poles));
    few = principal_frfs(completed.set(), sums);
    found = fit_sequentially(few, {.start = poles});
    left *= max_remaining_amplitude(few, found);
  }
}

// [lines] the variance of the force's gain error against that at the pole, which the residue takes up.
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

// What a fit leaves of a channel about a pole, in parts of its noise, and what noise would leave.
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

// Common poles leave the noise alone around every mode: the responses', and what the force's makes of a large FRF.
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
    if (energy > kExplained * expected) return false;
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
                               .relative_std = gain_deviation(set, set.channels[o].point, mode.pole.freq_Hz)});
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace

std::optional<std::vector<Mode>> identify_multi_output(const FrfDataset& set, const IdentifyOptions& options) {
  // An exponential window belongs to the pulse, which mixed channels do not have.
  if (set.window_decay_per_s() != 0) return std::nullopt;
  const Eigen::MatrixXd sums = principal_components(set, kMaxPrincipalFrfs);
  FrfDataset few = principal_frfs(set, sums);
  CompletedDecays completed(set);
  std::vector<FittedMode> found;
  // The clear modes first: what is missing of them after the records' ends would pass for hidden ones.
  SequentialFitOptions thorough = sequential_fit_options(options.effort);
  thorough.modes = options.modes;
  for (const SequentialFitOptions& peaks : {SequentialFitOptions{.max_rounds = 0, .modes = options.modes}, thorough}) {
    const std::size_t before = found.size();
    found = fit_sequentially(few, peaks);
    if (found.empty() || max_remaining_amplitude(set, found) > kMaxRemainingAmplitude) return std::nullopt;
    if (found.size() != before && completed.from_records()) complete(completed, sums, few, found);
  }
  const std::vector<Pole> poles = poles_of(found);
  bool move = false;  // seen while the rest goes on, which is seldom in vain
  parallel_for_cost(2, kMinFlops, [&](std::size_t task) {
    if (task == 0) move = any_pair_is_scatter(completed.set(), poles);
    if (task == 1 && options.effort == Effort::best) refine_jointly(few, found);
  });
  if (move) return std::nullopt;
  const JointFit fit = fit_residues(completed.set(), poles_of(found), covariance_of(found));
  if (!fits_to_noise(completed.set(), fit)) return std::nullopt;
  return modes_of(completed.set(), found, fit);
}

}  // namespace percuss::identify
