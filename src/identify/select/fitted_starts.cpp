#include "identify/select/fitted_starts.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math/assignment.hpp"
#include "identify/start/candidates.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMaxStartWidth = 0.05;  // of a stated frequency: a broader fit may move by this much
constexpr double kMinStartDamping = 3;   // standard deviations of the damping ratio
constexpr double kMinStartPeakToResidual = 3;
constexpr double kUnlike = 1e12;  // cost of a pole that is too far from a start …
constexpr double kNoPole = 10;    // … and of a start without a pole, beyond the greatest distance

}  // namespace

double bandwidths_from_start(const acquire::LineRange& lines, double asked_Hz, const Pole& pole) {
  const double range_Hz = std::max(kStatedRange * asked_Hz, kStatedRangeLines * lines.df_Hz());
  const double width_Hz =
      std::clamp(pole.half_power_Hz(), lines.df_Hz(), std::max(kMaxStartWidth * asked_Hz, range_Hz));
  return std::max(0.0, std::abs(pole.freq_Hz - asked_Hz) - range_Hz) / width_Hz;
}

std::vector<std::optional<std::size_t>> match_starts_to_poles(const acquire::LineRange& lines,
                                                              const std::vector<double>& start_Hz,
                                                              const std::vector<Pole>& poles, double max_bandwidths) {
  Eigen::MatrixXd cost(static_cast<Index>(start_Hz.size()), static_cast<Index>(poles.size()));
  for (Index s = 0; s < cost.rows(); ++s) {
    for (Index m = 0; m < cost.cols(); ++m) {
      const double asked_Hz = start_Hz[static_cast<std::size_t>(s)];
      const Pole& pole = poles[static_cast<std::size_t>(m)];
      const double moved = bandwidths_from_start(lines, asked_Hz, pole);
      cost(s, m) = moved > max_bandwidths ? kUnlike : std::abs(pole.freq_Hz - asked_Hz) / asked_Hz + moved;
    }
  }
  return assign_rows(cost, max_bandwidths + kNoPole);
}

std::optional<RefusedStart> refusal_of(const acquire::LineRange& lines, double asked_Hz, const FittedMode& found) {
  RefusedStart at{.asked_Hz = asked_Hz,
                  .pole = found.mode.pole,
                  .damping_std = found.mode.damping_std,
                  .peak_to_residual = found.peak_to_residual};
  if (bandwidths_from_start(lines, asked_Hz, at.pole) > kMaxBandwidthsFromStart) {
    at.reason = RefusedStart::Reason::moved;
  } else if (at.pole.damping_ratio < kMinStartDamping * at.damping_std) {
    at.reason = RefusedStart::Reason::undamped;
  } else if (at.peak_to_residual < kMinStartPeakToResidual) {
    at.reason = RefusedStart::Reason::no_resonance;
  } else {
    return std::nullopt;
  }
  return at;
}

FittedStarts fit_starts(const FrfDataset& set, std::vector<double> start_Hz, Effort effort) {
  FittedStarts out;
  SequentialFitOptions options = sequential_fit_options(effort);
  options.start_Hz = std::move(start_Hz);
  while (!options.start_Hz.empty()) {
    out.modes = fit_sequentially(set, options);
    const auto partner = match_starts_to_poles(set.lines, options.start_Hz, poles_of(out.modes), kAnyDistance);
    std::vector<double> accepted_Hz;
    for (std::size_t s = 0; s < options.start_Hz.size(); ++s) {
      const auto why = partner[s] ? refusal_of(set.lines, options.start_Hz[s], out.modes[*partner[s]]) : std::nullopt;
      if (why) out.refused.push_back(*why);
      if (!why) accepted_Hz.push_back(options.start_Hz[s]);
    }
    if (accepted_Hz.size() == options.start_Hz.size()) return out;
    options.start_Hz = std::move(accepted_Hz);
  }
  out.modes.clear();
  return out;
}

}  // namespace percuss::identify
