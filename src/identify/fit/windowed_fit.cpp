#include "identify/fit/windowed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/budget.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/model/point_columns.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMinWindowLines = 8;  // lines on either side of a pole
// Lines on either side of a pole: the polynomial follows other modes' tails only over a short window.
constexpr double kMaxWindowLines = 400;
// Of the strongest line's power: FRFs are meaningless at the zeros of a pulse's spectrum.
constexpr double kMinForcePower = 1e-6;
constexpr double kMinWindowNoise = 1e-3;        // of the noise elsewhere: an FRF without residual keeps a finite weight
constexpr std::size_t kFlopsPerPowerLine = 10;  // of |H|² and its comparison
constexpr std::size_t kOutgrown = 2;  // a window is replaced if the new one has more than this many times its lines
constexpr int kMaxPasses = 5;         // of widening
constexpr double kGroupingGap = 4;    // bandwidths or lines: closer modes are fitted together

// Takes the residues and the noise of mode m from the group that held it before.
void carry_over(const std::vector<FitGroup>& before, FitGroup& group, std::size_t m) {
  for (const FitGroup& old : before) {
    for (std::size_t i = 0; i < old.fit.poles.size(); ++i) {
      if (old.fit.poles[i].freq_Hz != group.fit.poles[m].freq_Hz || old.fit.residues.size() == 0) continue;
      group.fit.residues.col(static_cast<Index>(m)) = old.fit.residues.col(static_cast<Index>(i));
      if (old.fit.poles.size() == group.fit.poles.size()) group.fit.noise = old.fit.noise;
    }
  }
}

// The largest |H| of a channel over the lines at which the hammer has power.
double largest_driven_magnitude(const FrfDataset& set, const FrfChannel& channel) {
  const std::vector<double>& ff = set.points[channel.point].ff;
  const double min_power = ff.empty() ? 0 : kMinForcePower * *std::max_element(ff.begin(), ff.end());
  double largest = 0;
  for (std::size_t k = 0; k < channel.frf.size(); ++k) {
    if (ff.empty() || ff[k] > min_power) largest = std::max(largest, std::norm(channel.frf[k]));
  }
  return std::sqrt(largest);
}

}  // namespace

WindowedFit::WindowedFit(const FrfDataset& set, const WindowedFitOptions& options)
    : set_(set), options_(options), noise_(set), largest_(VectorXd::Zero(static_cast<Index>(set.channels.size()))) {
  parallel_for_cost(set.channels.size(), kFlopsPerPowerLine * set.lines.count, [&](std::size_t o) {
    largest_(static_cast<Index>(o)) = largest_driven_magnitude(set, set.channels[o]);
  });
}

std::vector<Pole> WindowedFit::poles() const {
  std::vector<Pole> all;
  for (const FitGroup& group : groups_) all.insert(all.end(), group.fit.poles.begin(), group.fit.poles.end());
  return all;
}

void WindowedFit::place_window(FitGroup& group) const {
  double low = 1e300;
  double high = 0;
  for (const Pole& pole : group.fit.poles) {
    const double half = std::clamp(options_.window_widths * width_Hz(pole), kMinWindowLines * set_.lines.df_Hz(),
                                   kMaxWindowLines * set_.lines.df_Hz());
    low = std::min(low, pole.freq_Hz - half);
    high = std::max(high, pole.freq_Hz + half);
  }
  // At least two lines more than twice the complex residues and polynomial coefficients of one FRF, also at the band's
  // edge.
  const auto min_count = 2 * (group.fit.poles.size() + LocalFitOptions{}.residual_terms) + 2;
  group.first = set_.lines.nearest(low);
  std::size_t last = set_.lines.nearest(high);
  while (last - group.first + 1 < min_count && last - group.first + 1 < set_.lines.count) {
    if (group.first > 0) --group.first;
    if (last + 1 < set_.lines.count) ++last;
  }
  group.count = last - group.first + 1;
}

// The same poles, and a window that moved by at most a tenth of its width.
bool WindowedFit::same_window(const FitGroup& before, const FitGroup& group) const {
  const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
  const std::size_t max_shift = before.count / 10;
  return before.fit.poles == group.fit.poles && apart(before.first, group.first) <= max_shift &&
         apart(before.first + before.count, group.first + group.count) <= max_shift;
}

bool WindowedFit::unchanged(std::size_t group, const std::vector<VectorXcd>& data) const {
  const std::vector<VectorXcd>& before = fitted_to_[group];
  if (before.empty()) return false;
  const Eigen::MatrixXd smooth = orthonormal_polynomials(before.front().size(), LocalFitOptions{}.residual_terms);
  double change = 0;
  for (std::size_t o = 0; o < data.size(); ++o) {
    const double noise = groups_[group].fit.noise(static_cast<Index>(o));
    const VectorXcd moved = data[o] - before[o];
    change += (moved - smooth * (smooth.transpose() * moved)).squaredNorm() / (noise * noise);
  }
  return change < options_.change_tolerance * options_.change_tolerance;
}

double WindowedFit::gap(const Pole& below, const Pole& above) const {
  return (above.freq_Hz - below.freq_Hz) / std::max({width_Hz(below), width_Hz(above), set_.lines.df_Hz()});
}

// Close modes must be fitted together; a group that is too large is split at its widest gap.
void WindowedFit::add_groups(std::span<const Pole> poles) {
  if (poles.size() <= kMaxGroupSize) {
    groups_.emplace_back().fit.poles.assign(poles.begin(), poles.end());
    return;
  }
  std::size_t widest = 1;
  for (std::size_t m = 2; m < poles.size(); ++m) {
    if (gap(poles[m - 1], poles[m]) > gap(poles[widest - 1], poles[widest])) widest = m;
  }
  add_groups(poles.first(widest));
  add_groups(poles.subspan(widest));
}

void WindowedFit::replace(std::vector<Pole> poles) {
  const std::vector<FitGroup> before = std::move(groups_);
  std::vector<std::vector<VectorXcd>> fitted_to = std::move(fitted_to_);
  groups_.clear();
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
  for (std::size_t first = 0; first < poles.size();) {
    std::size_t end = first + 1;
    while (end < poles.size() && gap(poles[end - 1], poles[end]) < kGroupingGap) ++end;
    add_groups({poles.data() + first, end - first});
    first = end;
  }
  const auto channels = static_cast<Index>(set_.channels.size());
  for (FitGroup& group : groups_) {
    group.fit.residues = Eigen::MatrixXcd::Zero(channels, static_cast<Index>(group.fit.poles.size()));
    for (std::size_t m = 0; m < group.fit.poles.size(); ++m) carry_over(before, group, m);
    place_window(group);
  }
  fitted_to_.assign(groups_.size(), {});
  for (std::size_t b = 0; b < before.size(); ++b) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!same_window(before[b], groups_[g])) continue;
      groups_[g] = before[b];
      fitted_to_[g] = std::move(fitted_to[b]);
    }
  }
}

void WindowedFit::sweep() {
  fit_all();
  replace(poles());  // poles that moved may now belong to one group
  fit_all();
}

void WindowedFit::widen() {
  for (int pass = 0; pass < kMaxPasses && has_outgrown_window(); ++pass) {
    replace(poles());
    fit_all();
  }
}

// The groups are fitted in turn, each with the latest contributions of its neighbours. In a parallel fit without them,
// half of the modes of a dense group are lost.
void WindowedFit::fit_all() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    FitGroup& group = groups_[g];
    auto data = data_without_other_modes(group);
    if (unchanged(g, data)) continue;
    // The residual of a first fit gives each FRF's noise in this window, which may differ from its noise elsewhere.
    if (group.fit.noise.size() == 0) group.fit = fit(group, data, group.fit.poles, noise(group), kTrialTolerance);
    group.fit = fit(group, data, group.fit.poles, residual_noise(group));
    fitted_to_[g] = std::move(data);
  }
}

// A resonance may turn out broader than the window that its first pole defined.
bool WindowedFit::has_outgrown_window() const {
  return std::any_of(groups_.begin(), groups_.end(), [&](const FitGroup& group) {
    FitGroup anew{.fit = {.poles = group.fit.poles}};
    place_window(anew);
    return anew.count > kOutgrown * group.count;
  });
}

void WindowedFit::subtract(const LocalFit& fit, std::size_t mode, const FitGroup& window,
                           std::vector<VectorXcd>& data) const {
  const bool decayed = decays_within_record(fit.poles[mode], set_.points.front(), set_.lines);
  const PointValues values(fit.poles[mode], set_, window.first, window.count);
  std::size_t point = set_.points.size();
  std::vector<Complex> work;
  std::span<const Complex> column;
  for (std::size_t o = 0; o < data.size(); ++o) {
    const bool same = point < set_.points.size() && (decayed || set_.channels[o].point == point);
    if (!same) column = values.at(set_.points[set_.channels[o].point], work);
    point = set_.channels[o].point;
    add_scaled(data[o].data(), -fit.residues(static_cast<Index>(o), static_cast<Index>(mode)), column.data(),
               column.size());
  }
}

std::vector<VectorXcd> WindowedFit::data_without_other_modes(const FitGroup& group) const {
  std::vector<VectorXcd> data;
  for (const FrfChannel& channel : set_.channels) {
    data.emplace_back(Eigen::Map<const VectorXcd>(channel.frf.data() + group.first, static_cast<Index>(group.count)));
  }
  for (const FitGroup& other : groups_) {
    if (&other == &group || other.fit.residues.isZero(0)) continue;
    check_budget();
    for (std::size_t m = 0; m < other.fit.poles.size(); ++m) subtract(other.fit, m, group, data);
  }
  return data;
}

std::vector<VectorXcd> WindowedFit::residual() const {
  std::vector<VectorXcd> all(set_.channels.size(), VectorXcd(static_cast<Index>(set_.lines.count)));
  parallel_for_chunks(set_.lines.count, kFlopsPerColumnLine * poles().size(),
                      [&](std::size_t first, std::size_t count) {
                        // These lines belong to no group, so that all groups are subtracted.
                        const auto part = data_without_other_modes(FitGroup{.fit = {}, .first = first, .count = count});
                        for (std::size_t o = 0; o < all.size(); ++o)
                          all[o].segment(static_cast<Index>(first), static_cast<Index>(count)) = part[o];
                      });
  return all;
}

LocalFit WindowedFit::fit(const FitGroup& group, const std::vector<VectorXcd>& data, std::vector<Pole> start,
                          const VectorXd& noise_scale, double tolerance) const {
  return fit_locally(set_, data, noise_scale, std::move(start),
                     {.first = group.first,
                      .count = group.count,
                      .tolerance = tolerance,
                      .change_tolerance = options_.change_tolerance});
}

VectorXd WindowedFit::residual_noise(const FitGroup& group) const {
  return group.fit.noise.cwiseMax(kMinWindowNoise * noise(group));
}

}  // namespace percuss::identify
