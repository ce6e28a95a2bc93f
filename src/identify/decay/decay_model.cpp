#include "identify/decay/decay_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "core/units.hpp"
#include "identify/decay/decay_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kMaxTogether = 8;
constexpr double kStill = 1e-11;     // relative change of a rate in one sweep, below which the fit ends
constexpr double kStillStds = 1e-3;  // the same in standard deviations of the rate
constexpr double kOtherLevel = 0.1;  // relative change of the noise of a hit or of a line that calls for a new fit

double frequency_Hz(const FittedDecay& mode) { return mode.rate.rate_radps.imag() / kTwoPi; }

// First line and one past the last.
std::pair<std::size_t, std::size_t> window_of(const DecayRate& rate, const DecaySpectra& spectra,
                                              const DecayWindows& windows) {
  const double half_power = -rate.rate_radps.real() / std::numbers::pi / spectra.df_Hz();
  const double reach =
      std::min(std::max(windows.half_power_bandwidths * std::max(half_power, 0.0), windows.lines), windows.max_lines);
  const double centre = rate.rate_radps.imag() / kTwoPi / spectra.df_Hz();
  const auto lines = static_cast<double>(spectra.lines.rows());
  const double last = spectra.samples % 2 == 0 ? lines - 1 : lines;  // without the lines that are real
  const double first = std::clamp(std::floor(centre - reach), 1.0, last - 1);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::clamp(centre + reach + 1, first + 1, last))};
}

std::vector<std::vector<std::size_t>> split(std::vector<std::size_t> members, const std::vector<FittedDecay>& modes) {
  if (members.size() <= kMaxTogether) return {members};
  std::size_t at = 1;
  double widest = -1;
  for (std::size_t i = 1; i < members.size(); ++i) {
    const double gap = frequency_Hz(modes[members[i]]) - frequency_Hz(modes[members[i - 1]]);
    if (gap > widest) at = i;
    widest = std::max(widest, gap);
  }
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>(at);
  auto out = split({members.begin(), middle}, modes);
  for (auto& group : split({middle, members.end()}, modes)) out.push_back(std::move(group));
  return out;
}

std::vector<std::vector<std::size_t>> groups_of(const std::vector<FittedDecay>& modes, const DecaySpectra& spectra,
                                                const DecayWindows& windows) {
  std::vector<std::vector<std::size_t>> out;
  std::vector<std::size_t> members;
  std::size_t end = 0;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const auto [first, last] = window_of(modes[m].rate, spectra, windows);
    if (!members.empty() && first >= end) {
      for (auto& group : split(members, modes)) out.push_back(std::move(group));
      members.clear();
    }
    members.push_back(m);
    end = std::max(end, last);
  }
  if (!members.empty()) {
    for (auto& group : split(members, modes)) out.push_back(std::move(group));
  }
  return out;
}

// Whether a rate stands still after it changed by `step`.
bool is_still(const FittedDecay& mode, const Complex& step) {
  const double std_radps = std::sqrt(std::max(0.0, mode.covariance.trace()));
  return std::abs(step) < std::max(kStill * std::abs(mode.rate.rate_radps), kStillStds * std_radps);
}

// Replaces weights where one changes by more than kOtherLevel. Returns whether it did. Empty weights are all 1.
bool replace_if_changed(const Eigen::VectorXd& value, Eigen::VectorXd& weights) {
  const Eigen::VectorXd old = weights.size() == 0 ? Eigen::VectorXd::Ones(value.size()).eval() : weights;
  if (((value - old).array().abs() <= kOtherLevel * old.array()).all()) return false;
  weights = value;
  return true;
}

void sort(std::vector<FittedDecay>& modes) {
  std::stable_sort(modes.begin(), modes.end(), [](const FittedDecay& a, const FittedDecay& b) {
    return a.rate.rate_radps.imag() < b.rate.rate_radps.imag();
  });
}

}  // namespace

void DecayModel::add(const DecayRate& rate) {
  FittedDecay mode{.rate = rate,
                   .amplitude = Eigen::RowVectorXcd::Zero(measured_->lines.cols()),
                   .covariance = Eigen::Matrix2d::Zero(),
                   .inverse_gram = Eigen::Matrix2d::Zero(),
                   .noise = {},
                   .hit_step = {},
                   .hit_covariance = {},
                   .settled = {}};
  unsettle_near(rate);
  modes_.push_back(std::move(mode));
  sort(modes_);
}

void DecayModel::remove(std::size_t mode) {
  const DecayRate rate = modes_[mode].rate;
  modes_.erase(modes_.begin() + static_cast<std::ptrdiff_t>(mode));
  unsettle_near(rate);
}

void DecayModel::unsettle_near(const DecayRate& rate) {
  const auto [first, last] = window_of(rate, *measured_, {});
  for (FittedDecay& mode : modes_) {
    const auto [low, high] = window_of(mode.rate, *measured_, {});
    if (low < last && first < high) {
      mode.settled.reset();
    } else if (mode.settled) {
      mode.settled = DecayAccuracy::rough;  // the next full fit includes it again, even if the change is far away
    }
  }
}

void DecayModel::set_noise(const Eigen::MatrixXd& noise) {
  const auto channels = static_cast<Index>(measured_->channels), hits = static_cast<Index>(measured_->hits);
  const Eigen::VectorXd log_power = noise.row(0).transpose().array().log();
  const Eigen::Map<const Eigen::MatrixXd> table(log_power.data(), channels, hits);
  const Eigen::MatrixXd above = (table.colwise() - table.rowwise().mean()).array().exp();
  const bool other_levels = replace_if_changed(above.reshaped(), level_);
  const bool other_lines = replace_if_changed(smooth_noise_std(noise), line_std_);
  if (!other_levels && !other_lines) return;
  for (FittedDecay& mode : modes_) mode.settled.reset();
}

double DecayModel::variance_at(const DecayRate& rate) const {
  if (line_std_.size() == 0) return 1;
  const double line = std::round(rate.rate_radps.imag() / kTwoPi / measured_->df_Hz());
  const auto last = static_cast<double>(line_std_.size() - 1);
  return std::pow(line_std_(static_cast<Index>(std::clamp(line, 0.0, last))), 2);
}

bool DecayModel::is_settled(const std::vector<std::size_t>& members, DecayAccuracy accuracy) const {
  return std::all_of(members.begin(), members.end(), [&](std::size_t m) {
    const auto& settled = modes_[m].settled;
    return settled && (*settled == accuracy || *settled == DecayAccuracy::full);
  });
}

void DecayModel::subtract(const FittedDecay& mode, std::size_t first, Eigen::Ref<Eigen::MatrixXcd> lines) const {
  if (mode.amplitude.isZero(0)) return;
  const auto count = static_cast<std::size_t>(lines.rows());
  for (std::size_t at = 0; at < count; at += kDecayBlock_lines) {
    const std::size_t rows = std::min(kDecayBlock_lines, count - at);
    const Eigen::MatrixX2cd columns = decay_values(mode.rate, *measured_, first + at, rows);
    for (Index i = 0; i < lines.cols(); ++i) {
      lines.col(i).segment(static_cast<Index>(at), static_cast<Index>(rows)) -=
          columns.col(0) * mode.amplitude(i).real() + columns.col(1) * mode.amplitude(i).imag();
    }
  }
}

DecaySpectra DecayModel::residual() const {
  DecaySpectra out = *measured_;
  for (const FittedDecay& mode : modes_) subtract(mode, 0, out.lines);
  return out;
}

std::vector<std::pair<std::size_t, std::size_t>> DecayModel::windows_of(const std::vector<std::size_t>& members,
                                                                        const DecayWindows& windows) const {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;  // first, one past the last
  for (const std::size_t m : members) ranges.push_back(window_of(modes_[m].rate, *measured_, windows));
  std::sort(ranges.begin(), ranges.end());  // a broad mode's window may begin below its lower neighbour's
  std::vector<std::pair<std::size_t, std::size_t>> merged;  // first, count
  for (const auto& [first, last] : ranges) {
    if (!merged.empty() && first <= merged.back().first + merged.back().second) {
      auto& [start, count] = merged.back();
      count = std::max(start + count, last) - start;
    } else {
      merged.emplace_back(first, last - first);
    }
  }
  return merged;
}

Eigen::MatrixXcd DecayModel::data_of(const std::vector<std::pair<std::size_t, std::size_t>>& windows,
                                     const std::vector<std::size_t>& members) const {
  std::size_t lines = 0;
  for (const auto& [first, count] : windows) lines += count;
  Eigen::MatrixXcd data(static_cast<Index>(lines), measured_->lines.cols());
  Index row = 0;
  for (const auto& [first, count] : windows) {
    auto part = data.middleRows(row, static_cast<Index>(count));
    part = measured_->lines.middleRows(static_cast<Index>(first), static_cast<Index>(count));
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      if (std::find(members.begin(), members.end(), m) == members.end()) subtract(modes_[m], first, part);
    }
    row += static_cast<Index>(count);
  }
  return data;
}

Eigen::VectorXd DecayModel::line_std_of(const std::vector<std::pair<std::size_t, std::size_t>>& windows,
                                        Index lines) const {
  if (line_std_.size() == 0) return {};
  Eigen::VectorXd out(lines);
  Index row = 0;
  for (const auto& [first, count] : windows) {
    out.segment(row, static_cast<Index>(count)) =
        line_std_.segment(static_cast<Index>(first), static_cast<Index>(count));
    row += static_cast<Index>(count);
  }
  return out;
}

void DecayModel::fit_group(const std::vector<std::size_t>& members, const DecayWindows& windows) {
  DecayGroup group{.rates = {}, .windows = windows_of(members, windows), .level = level_, .line_std = {}};
  for (const std::size_t m : members) group.rates.push_back(modes_[m].rate);
  const Eigen::MatrixXcd data = data_of(group.windows, members);
  group.line_std = line_std_of(group.windows, data.rows());
  store(fit_decay_group(group, *measured_, data, windows.accuracy), members);
}

void DecayModel::store(const DecayGroupFit& fitted, const std::vector<std::size_t>& members) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    FittedDecay& mode = modes_[members[i]];
    const auto at = static_cast<Index>(2 * i);
    mode.rate = fitted.rates[i];
    mode.amplitude = fitted.amplitude.row(static_cast<Index>(i));
    mode.covariance = fitted.covariance.block<2, 2>(at, at);
    const double variance = variance_at(mode.rate);
    mode.inverse_gram = fitted.inverse_gram.block<2, 2>(at, at) / variance;
    mode.noise = fitted.noise * variance;
    mode.misfit = fitted.misfit;
    mode.converged = fitted.converged;
    mode.hit_step.clear();
    mode.hit_covariance.clear();
    for (std::size_t h = 0; h < measured_->hits; ++h) {
      mode.hit_step.emplace_back(fitted.hit_step[h].segment<2>(at));
      mode.hit_covariance.emplace_back(inverse_gram(fitted.hit_information[h]).block<2, 2>(at, at));
    }
  }
}

bool DecayModel::fit_unsettled(const std::vector<std::size_t>& members, const DecayWindows& windows) {
  std::vector<DecayRate> before;
  for (const std::size_t m : members) before.push_back(modes_[m].rate);
  fit_group(members, windows);
  bool still = true;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const FittedDecay& mode = modes_[members[i]];
    still = still && is_still(mode, mode.rate.rate_radps - before[i].rate_radps);
  }
  // These modes are subtracted from the data of the other groups, which must be fitted again. A search repeats only the
  // fits nearby.
  if (!still && windows.accuracy == DecayAccuracy::full) {
    for (FittedDecay& mode : modes_) mode.settled.reset();
  } else if (!still) {
    for (const DecayRate& rate : before) unsettle_near(rate);
    for (const std::size_t m : members) unsettle_near(modes_[m].rate);
  }
  const bool converged = modes_[members.front()].converged;
  for (const std::size_t m : members) modes_[m].settled = converged ? std::optional(windows.accuracy) : std::nullopt;
  return still && converged;
}

void DecayModel::fit(int sweeps, const DecayWindows& windows) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool still = true;
    for (const auto& group : groups_of(modes_, *measured_, windows)) {
      if (!is_settled(group, windows.accuracy)) still = fit_unsettled(group, windows) && still;
    }
    sort(modes_);
    if (still) return;
  }
}

}  // namespace percuss::identify
