#include "identify/select/frequency_scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/math/statistics.hpp"
#include "identify/model/frf_lines.hpp"
#include "identify/select/robust_mean.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr std::size_t kMinPoints = 3;        // each of two points may observe one mode of an orthogonal pair
constexpr double kMinScatterEnergy = 2;      // residual energy over the noise energy: below it there is no scatter
constexpr double kScatterFStatistic = 25;    // F statistic of separate poles
constexpr double kMaxScatterRatio = 15;      // of residual energies above the noise
constexpr double kNoiseError = 0.3;          // of the estimated noise energy
constexpr double kMaxScatterWidths = 3;      // bandwidths: poles farther apart are separate modes
constexpr double kMaxScatterWidthRatio = 6;  // of the half-power bandwidths: beyond it the poles are separate modes
// Largest distance of common poles that may stand for scatter, in standard deviations of the scatter.
constexpr double kMaxPoleDistance = 4;
constexpr double kMaxPoleOffset = 1;  // bandwidths: a separate pole farther away is another mode

// The mode with the largest peak, over all FRFs.
std::size_t highest_peak(const LocalFit& fit) {
  const auto height = [&](std::size_t m) {
    return fit.residues.col(static_cast<Index>(m)).norm() / fit.poles[m].damping_ratio;
  };
  std::size_t highest = 0;
  for (std::size_t m = 1; m < fit.poles.size(); ++m) highest = height(m) > height(highest) ? m : highest;
  return highest;
}

std::vector<std::size_t> strongest_first(const FrfDataset& set, const std::vector<VectorXcd>& data) {
  std::vector<double> energy(set.points.size());
  for (std::size_t o = 0; o < data.size(); ++o) energy[set.channels[o].point] += data[o].squaredNorm();
  std::vector<std::size_t> order(energy.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return energy[a] > energy[b]; });
  return order;
}

// Separate fits of a group at each impact point. Temperature, the strength of the blow, or the mass of the hammer or of
// a roving sensor change the natural frequencies between hits. Poles common to all points then do not fit.
struct PointFits {
  std::vector<LocalFit> fits;  // [points]; residues and noise of that point's FRFs, in their order
  double cost = 0;             // Σ of the fits' cost, see LocalFit
  std::size_t degrees = 0;     // Σ of the fits' degrees of freedom
};

// Fits the group's modes to each point separately, the strongest point first. Returns no fits once the cost exceeds
// `max_cost`.
PointFits fit_each_point(const FrfDataset& set, const WindowData& window, const FitGroup& group, double max_cost) {
  PointFits out;
  out.fits.resize(set.points.size());
  for (const std::size_t p : strongest_first(set, window.data)) {
    const PointSet one = set_of_point(set, p);
    std::vector<VectorXcd> its_data;
    VectorXd its_noise_scale(static_cast<Index>(one.channels.size()));
    for (std::size_t i = 0; i < one.channels.size(); ++i) {
      its_data.push_back(window.data[one.channels[i]]);
      its_noise_scale(static_cast<Index>(i)) = window.noise_scale(static_cast<Index>(one.channels[i]));
    }
    out.fits[p] =
        fit_locally(one.set, its_data, its_noise_scale, group.fit.poles, {.first = group.first, .count = group.count});
    out.cost += out.fits[p].cost;
    out.degrees += out.fits[p].degrees;
    if (out.cost > max_cost) return {};
  }
  return out;
}

// The points whose separate fit determines this mode.
std::vector<std::size_t> points_observing(const PointFits& points, const FitGroup& group, std::size_t mode,
                                          double width_Hz) {
  std::vector<std::size_t> observing;
  const auto m = static_cast<Index>(mode);
  for (std::size_t p = 0; p < points.fits.size(); ++p) {
    const LocalFit& fit = points.fits[p];
    const Pole& pole = fit.poles[mode];
    const bool near = std::abs(pole.freq_Hz - group.fit.poles[mode].freq_Hz) < kMaxPoleOffset * width_Hz;
    const bool sure = fit.freq_std_Hz(m) > 0 && fit.freq_std_Hz(m) < 0.5 * width_Hz && fit.damping_std(m) > 0 &&
                      fit.damping_std(m) < pole.damping_ratio;
    if (near && sure) observing.push_back(p);
  }
  return observing;
}

ScatteredMode scattered_mode(const WindowedFit& all, const FitGroup& group, const PointFits& points,
                             const std::vector<std::size_t>& observing, std::size_t mode) {
  const auto m = static_cast<Index>(mode);
  std::vector<double> freq_Hz, freq_std_Hz, damping, damping_std, size;
  for (const std::size_t p : observing) {
    size.push_back(points.fits[p].residues.col(m).norm());
    freq_Hz.push_back(points.fits[p].poles[mode].freq_Hz);
    freq_std_Hz.push_back(points.fits[p].freq_std_Hz(m));
    damping.push_back(points.fits[p].poles[mode].damping_ratio);
    damping_std.push_back(points.fits[p].damping_std(m));
  }
  const RobustMean frequency = robust_mean(freq_Hz, freq_std_Hz, size);
  const RobustMean zeta = robust_mean(damping, damping_std, size);
  const std::size_t channels = all.set().channels.size();
  ScatteredMode out{.pole = {.freq_Hz = frequency.value, .damping_ratio = zeta.value},
                    .freq_std_Hz = frequency.std,
                    .damping_std = zeta.std,
                    .freq_scatter_Hz = frequency.spread,
                    .residues = std::vector<Complex>(channels),
                    .own_poles = std::vector<std::optional<Pole>>(channels),
                    .residue_std = std::vector<double>(channels),
                    .noise = group.fit.noise};
  for (std::size_t p = 0; p < points.fits.size(); ++p) {
    const bool own = std::find(observing.begin(), observing.end(), p) != observing.end();
    const auto members = set_of_point(all.set(), p).channels;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto o = static_cast<Index>(members[i]);
      const auto at = static_cast<Index>(i);
      out.residues[members[i]] = own ? points.fits[p].residues(at, m) : group.fit.residues(o, m);
      if (own) out.own_poles[members[i]] = points.fits[p].poles[mode];
      out.residue_std[members[i]] = own ? points.fits[p].residue_std(at, m) : group.fit.residue_std(o, m);
      out.noise(o) = points.fits[p].noise(at);
    }
  }
  return out;
}

// The noise energy of all channels, in the unit of LocalFit::cost.
double noise_cost(const WindowData& window, const FitGroup& group) {
  return static_cast<double>(group.count) * (window.noise.array() / window.noise_scale.array()).square().sum();
}

// True where one pole per point can stand for these common poles: its frequency scatters as widely as they lie apart.
// A true pair has two fixed poles; the pole of a point then lies at one of them or between.
bool scatter_spans(const PointFits& points, const std::vector<Pole>& poles) {
  std::vector<double> freq_Hz, off_Hz, size;
  double width_Hz = 0;
  for (const LocalFit& fit : points.fits) {
    freq_Hz.push_back(fit.poles.front().freq_Hz);
    size.push_back(fit.residues.squaredNorm());
  }
  const double middle_Hz = weighted_median(freq_Hz, size);
  for (const double at_Hz : freq_Hz) off_Hz.push_back(std::abs(at_Hz - middle_Hz));
  const auto [low, high] = std::minmax_element(poles.begin(), poles.end(),
                                               [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
  for (const Pole& pole : poles) width_Hz = std::max(width_Hz, pole.half_power_Hz());
  const double max_distance_Hz = kMaxPoleDistance * kNormalMad * median(off_Hz);
  return high->freq_Hz - low->freq_Hz < std::max(max_distance_Hz, width_Hz);
}

}  // namespace

double max_scatter_energy(double further_mode, double noise) {
  return std::max(further_mode, noise) + std::max((kMaxScatterRatio - 1) * (further_mode - noise), kNoiseError * noise);
}

bool explained_by_freq_scatter(const FrfDataset& set, const WindowData& window, const FitGroup& one,
                               const FitGroup& more) {
  if (set.points.size() < kMinPoints || more.fit.degrees == 0) return false;
  // The costs are comparable: separate poles of one mode add fewer unknowns than one more common mode.
  const double max_cost = max_scatter_energy(more.fit.cost, noise_cost(window, more));
  const PointFits points = fit_each_point(set, window, one, max_cost);
  return !points.fits.empty() && (one.fit.poles.size() > 1 || scatter_spans(points, more.fit.poles));
}

std::optional<Pole> merge_if_scattered(const WindowedFit& all, const FitGroup& group) {
  const auto& poles = group.fit.poles;
  if (poles.size() < 2 || all.set().points.size() < kMinPoints) return std::nullopt;
  const WindowData window{
      .data = all.data_without_other_modes(group), .noise_scale = all.residual_noise(group), .noise = all.noise(group)};
  FitGroup several = group;
  several.fit = all.fit(group, window.data, poles, window.noise_scale);
  const std::size_t main = highest_peak(several.fit);
  for (const Pole& pole : several.fit.poles) {
    const double apart = std::abs(pole.freq_Hz - several.fit.poles[main].freq_Hz);
    const double broader = all.width_Hz(pole) / all.width_Hz(several.fit.poles[main]);
    if (apart > kMaxScatterWidths * all.width_Hz(several.fit.poles[main]) || broader > kMaxScatterWidthRatio ||
        broader < 1 / kMaxScatterWidthRatio)
      return std::nullopt;
  }
  FitGroup one = group;
  one.fit.poles = {several.fit.poles[main]};
  if (!explained_by_freq_scatter(all.set(), window, one, several)) return std::nullopt;
  return one.fit.poles.front();
}

void subtract_freq_scatter(const FrfDataset& set, const FitGroup& group, std::size_t mode,
                           const ScatteredMode& scattered, std::vector<VectorXcd>& residual) {
  for (std::size_t o = 0; o < residual.size(); ++o) {
    if (!scattered.own_poles[o]) continue;
    const PointForce& force = set.points[set.channels[o].point];
    const auto contribution = [&](const Pole& pole, Complex residue) {
      return VectorXcd(residue * mode_column(pole, force, set.lines, 0, set.lines.count, ColumnContent::value).value);
    };
    residual[o] +=
        contribution(group.fit.poles[mode], group.fit.residues(static_cast<Index>(o), static_cast<Index>(mode))) -
        contribution(*scattered.own_poles[o], scattered.residues[o]);
  }
}

std::vector<ScatteredMode> scattered_modes(const WindowedFit& all, const FitGroup& group) {
  const std::size_t count = all.set().points.size();
  if (count < kMinPoints) return {};
  if ((group.fit.noise.array() / all.noise(group).array()).square().mean() < kMinScatterEnergy) return {};
  const WindowData window{
      .data = all.data_without_other_modes(group), .noise_scale = all.residual_noise(group), .noise = all.noise(group)};
  const LocalFit common = all.fit(group, window.data, group.fit.poles, window.noise_scale);
  const PointFits points = fit_each_point(all.set(), window, group, common.cost);
  if (points.degrees == 0 || common.degrees <= points.degrees) return {};
  const double gained = (common.cost - points.cost) / static_cast<double>(common.degrees - points.degrees);
  if (gained < kScatterFStatistic * points.cost / static_cast<double>(points.degrees)) return {};
  std::vector<ScatteredMode> out;
  for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
    const auto observing = points_observing(points, group, m, all.width_Hz(group.fit.poles[m]));
    if (observing.size() < kMinPoints) return {};
    out.push_back(scattered_mode(all, group, points, observing, m));
  }
  return out;
}

}  // namespace percuss::identify
