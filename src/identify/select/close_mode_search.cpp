#include "identify/select/close_mode_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel/parallel.hpp"
#include "identify/noise/window_noise.hpp"
#include "identify/select/frequency_scatter.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A close mode must reduce the residual energy above the noise to this part or less.
constexpr double kSplitGain = 0.25;
constexpr double kSplitTest = 25;    // F statistic
constexpr double kSplitStart = 0.4;  // half-power bandwidths from the single pole to either start pole
// A group is searched if its residual energy exceeds the lower of two limits: kMisfit times the noise energy, and
// kMisfitDeviations standard deviations above the noise energy.
constexpr double kMisfit = 2;
constexpr double kMisfitDeviations = 6;
constexpr std::size_t kFlopsPerTrialLine = 1000;  // operations of a trial per line and FRF

// The FRFs whose residual in the group's window is significantly above the noise.
std::vector<Index> misfitting_channels(const WindowedFit& all, const FitGroup& group) {
  std::vector<Index> channels;
  const VectorXd expected = all.noise(group);
  const double chance = kMisfitDeviations / std::sqrt(static_cast<double>(group.count));
  for (Index o = 0; o < expected.size(); ++o) {
    if (std::pow(group.fit.noise(o) / expected(o), 2) > std::min(kMisfit, 1 + chance)) channels.push_back(o);
  }
  return channels;
}

// The residual energy above the noise after a split, over the same energy before it: the mean of this ratio over these
// FRFs. Ratios are averaged, not energies, because many FRFs observe little of a mode.
double residual_energy_ratio(const std::vector<Index>& channels, const VectorXd& expected, const LocalFit& before,
                             const LocalFit& after) {
  double sum = 0;
  for (const Index o : channels) {
    const auto beyond = [&](double noise) { return std::max(0.0, noise * noise - expected(o) * expected(o)); };
    sum += beyond(after.noise(o)) / beyond(before.noise(o));
  }
  return sum / static_cast<double>(channels.size());
}

// Replaces pole m by two poles, one on either side.
std::vector<Pole> split(std::vector<Pole> poles, std::size_t m) {
  const double apart_Hz = kSplitStart * poles[m].half_power_Hz();
  poles.push_back({.freq_Hz = poles[m].freq_Hz + apart_Hz, .damping_ratio = poles[m].damping_ratio});
  poles[m].freq_Hz -= apart_Hz;
  return poles;
}

// The poles of the group, with one more where a close mode is found.
std::vector<Pole> try_close_mode(const WindowedFit& all, const FitGroup& group, const AcceptanceContext& context) {
  const std::vector<Pole>& now = group.fit.poles;
  const std::size_t channels = all.set().channels.size(), unknowns = 2 + 2 * channels;
  const bool enough_data = group.fit.degrees > 2 * unknowns;
  if (!enough_data || now.size() >= WindowedFit::kMaxGroupSize) return now;
  const std::vector<Index> misfitting = misfitting_channels(all, group);
  if (misfitting.empty()) return now;
  const auto data = all.data_without_other_modes(group);
  const VectorXd noise_scale = all.residual_noise(group);
  std::vector<LocalFit> fits(now.size() + 1);  // the present poles, and each mode split in turn
  parallel_for_cost(fits.size(), kFlopsPerTrialLine * channels * group.count, [&](std::size_t i) {
    fits[i] = i == 0 ? all.fit(group, data, now, noise_scale)
                     : all.fit(group, data, split(now, i - 1), noise_scale, WindowedFit::kTrialTolerance);
  });
  const LocalFit one = fits.front();
  FitGroup best = group;
  best.fit = one;
  for (std::size_t i = 1; i < fits.size(); ++i) {
    FitGroup trial = group;
    trial.fit = std::move(fits[i]);
    if (trial.fit.cost < best.fit.cost && trial.fit.degrees > 0 && accept_all_modes(all, trial, context))
      best = std::move(trial);
  }
  const double gained = (one.cost - best.fit.cost) / static_cast<double>(unknowns);
  const double left = best.fit.cost / static_cast<double>(best.fit.degrees);
  if (residual_energy_ratio(misfitting, all.noise(group), one, best.fit) >= kSplitGain ||
      gained <= kSplitTest * WindowNoise(all.set()).max_factor() * left)
    return now;
  return explained_by_freq_scatter(all.set(), {.data = data, .noise_scale = noise_scale, .noise = all.noise(group)},
                                   group, best)
             ? now
             : best.fit.poles;
}

}  // namespace

bool CloseModeSearch::tried(const FitGroup& group) const {
  return std::any_of(tried_.begin(), tried_.end(), [&](const Tried& one) {
    return one.first == group.first && one.count == group.count && one.poles == group.fit.poles;
  });
}

std::vector<Pole> CloseModeSearch::next(const WindowedFit& all, const AcceptanceContext& context) {
  const std::vector<FitGroup>& groups = all.groups();
  const std::size_t lines = groups.empty() ? 0 : groups.front().count;
  std::vector<std::vector<Pole>> split(groups.size());
  parallel_for_cost(groups.size(), kFlopsPerTrialLine * all.set().channels.size() * lines, [&](std::size_t g) {
    split[g] = tried(groups[g]) ? groups[g].fit.poles : try_close_mode(all, groups[g], context);
  });
  std::vector<Pole> poles;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const FitGroup& group = groups[g];
    if (split[g].size() == group.fit.poles.size() && !tried(group))
      tried_.push_back({.first = group.first, .count = group.count, .poles = group.fit.poles});
    poles.insert(poles.end(), split[g].begin(), split[g].end());
  }
  return poles;
}

}  // namespace percuss::identify
