#include "identify/select/found_before.hpp"

#include <algorithm>
#include <cmath>

#include "identify/noise/line_noise.hpp"
#include "identify/select/frequency_scatter.hpp"
#include "identify/select/joint_selection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr double kScatterReach = 4;  // standard deviations of the scatter: a pair farther apart does not imitate it
// Largest norm of the residues of a partner that describes a drift during the decay, over the norm of its mode's.
constexpr double kMaxDriftShare = 0.3;

}  // namespace

std::vector<VectorXcd> residual_before(const FrfDataset& set, const std::vector<FittedMode>& modes,
                                       std::vector<VectorXcd> residual) {
  if (residual.empty()) {
    residual = fit_residues(set, poles_of(modes)).residual;
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
  std::size_t unknowns = modes.size() * unknowns_per_mode(set);
  for (const FittedMode& mode : modes) {
    if (mode.mode.freq_scatter_Hz > 0) unknowns += 2 * (set.points.size() - 1);
  }
  return unknowns;
}

std::vector<std::size_t> scatter_partners(const FrfDataset& set, const std::vector<FittedMode>& modes,
                                          const JointFit& fit) {
  const LineNoise line_noise(set);
  std::vector<std::size_t> partners;
  for (const FittedMode& mode : modes) {
    if (!(mode.mode.freq_scatter_Hz > 0)) continue;
    const double reach_Hz =
        std::max(kScatterReach * mode.mode.freq_scatter_Hz, resolved_width_Hz(mode.mode.pole, set.lines));
    std::vector<std::size_t> near;
    for (std::size_t m = 0; m < fit.poles.size(); ++m) {
      if (std::abs(fit.poles[m].freq_Hz - mode.mode.pole.freq_Hz) < reach_Hz) near.push_back(m);
    }
    if (near.size() < 2) continue;
    const auto by_freq = [&](std::size_t a, std::size_t b) { return fit.poles[a].freq_Hz < fit.poles[b].freq_Hz; };
    const auto [low, high] = std::minmax_element(near.begin(), near.end(), by_freq);
    double separate = 0, pair = 0, noise_energy = 0;
    const Eigen::VectorXd noise = line_noise.over(mode.first, mode.count);
    for (std::size_t o = 0; o < fit.residual.size(); ++o) {
      const double n = mode.noise(static_cast<Index>(o));
      separate += n * n * static_cast<double>(mode.count);
      noise_energy += std::pow(noise(static_cast<Index>(o)), 2) * static_cast<double>(mode.count);
      pair += fit.residual[o].segment(static_cast<Index>(mode.first), static_cast<Index>(mode.count)).squaredNorm();
    }
    if (fit.poles[*high].freq_Hz - fit.poles[*low].freq_Hz >= reach_Hz ||
        separate >= max_scatter_energy(pair, noise_energy))
      continue;
    const auto size = [&](std::size_t m) { return fit.residues.col(static_cast<Index>(m)).norm(); };
    const auto peak = [&](std::size_t m) { return size(m) / fit.poles[m].damping_ratio; };
    const std::size_t strongest =
        *std::max_element(near.begin(), near.end(), [&](std::size_t a, std::size_t b) { return peak(a) < peak(b); });
    for (const std::size_t m : near) {
      if (m == strongest) continue;
      const double apart_Hz = std::abs(fit.poles[m].freq_Hz - fit.poles[strongest].freq_Hz);
      const double scatter_share = kScatterReach * mode.mode.freq_scatter_Hz / apart_Hz;
      if (size(m) <= std::max(scatter_share, kMaxDriftShare) * size(strongest)) partners.push_back(m);
    }
  }
  std::sort(partners.begin(), partners.end());
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  return partners;
}

}  // namespace percuss::identify
