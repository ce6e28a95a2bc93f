#include "identify/select/mode_acceptance.hpp"

#include <algorithm>
#include <cmath>

#include "identify/noise/force_noise.hpp"
#include "identify/select/joint_selection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMinSignificance = 6;      // standard deviations of a residue
constexpr double kMinPairSignificance = 3;  // … of one mode of a resolved close pair
constexpr double kMinPeakToResidual = 3;    // a mode's peak over the rms residual of its window
constexpr double kMaxMisfit =
    8;  // limit of the misfit's factor: a peak 24 times the residual is accepted at any misfit
constexpr double kBroadDamping = 0.05;  // damping ratio from which that limit does not apply
constexpr double kOutOfBandFactor =
    12;  // above the force's bandwidth: small peaks in the side lobes of its spectrum are not modes
constexpr double kMaxModeWidth = 0.25;  // of the band: a wider resonance cannot be distinguished from the background
constexpr double kForceNoise = 8;       // standard deviations of the gain error from the force's noise
constexpr std::size_t kGainLines = 64;  // lines at most at which the error is computed
constexpr double kUnknownGain =
    1e-3;  // gain error assumed for an unknown force: typical of a good hammer near its bandwidth
// Of the largest line: smaller peaks are within the error of the fit's polynomial.
constexpr double kDynamicRange = 1e-5;
constexpr double kMinSplit = 0.5;           // bandwidths between two modes after a split …
constexpr double kMinResolvedSplit = 0.05;  // … where their residual is only noise
constexpr double kNoiseAlone =
    1.5;  // ratio of residual to noise: below it, the residual is only noise, without misfit or frequency scatter
constexpr double kUndecayedAmplitude = 0.5;    // amplitude left at the record's end: mains hum keeps all of it
constexpr double kMinDampingSignificance = 3;  // standard deviations of the damping of such a mode; hum has none
constexpr double kPreciseDamping = 0.05;       // relative standard deviation of a precise damping ratio …
constexpr double kDampingMargin = 2;           // … which may exceed the limit by this many standard deviations
constexpr double kInfiniteRatio = 1e9;         // a quotient with zero noise

double max_misfit(const WindowedFit& all, const FitGroup& group) {
  return group.fit.noise.cwiseQuotient(all.noise(group)).maxCoeff();
}

// A residue over its standard deviation.
double significance(const LocalFit& fit, Index channel, std::size_t mode) {
  const double std = fit.residue_std(channel, static_cast<Index>(mode));
  return std > 0 ? std::abs(fit.residues(channel, static_cast<Index>(mode))) / std : kInfiniteRatio;
}

// True for a mode of a close pair whose residual is only noise. The other mode can take over most of its residue, so
// the residue is uncertain, but the number of modes is not.
bool is_resolved_pair(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const Pole& pole = group.fit.poles[mode];
  const auto beside = [&](const Pole& other) {
    return &other != &pole &&
           std::abs(other.freq_Hz - pole.freq_Hz) < std::min(all.width_Hz(other), all.width_Hz(pole));
  };
  return max_misfit(all, group) < kNoiseAlone && std::any_of(group.fit.poles.begin(), group.fit.poles.end(), beside);
}

// True where the mode's peak in some FRF is above the fit's model error.
bool above_dynamic_range(const WindowedFit& all, const LocalFit& fit, std::size_t mode) {
  for (Index o = 0; o < fit.residues.rows(); ++o) {
    const double peak = std::abs(fit.residues(o, static_cast<Index>(mode))) / (2 * fit.poles[mode].damping_ratio);
    if (peak > kDynamicRange * all.largest_magnitude()(o)) return true;
  }
  return false;
}

// The largest |H| within `reach` lines of a frequency.
double largest_within(const std::vector<Complex>& frf, const acquire::LineRange& lines, double freq_Hz, double reach) {
  const double at = lines.position(freq_Hz);
  double largest = 0;  // as power
  for (std::size_t k = lines.at(at - reach); k <= lines.at(at + reach); ++k)
    largest = std::max(largest, std::norm(frf[k]));
  return std::sqrt(largest);
}

// The largest standard deviation of an FRF within `reach` lines of a frequency, from a gain error that changes over
// these lines. A gain error common to all of them only scales the modes. So the gain error at the largest |H| is
// subtracted: the force's noise at a strong mode then does not hide a weak mode beside it. 0 where that noise is
// unknown.
double changing_gain_error(const FrfDataset& set, const FrfChannel& channel, double freq_Hz, double reach) {
  const double at = set.lines.position(freq_Hz);
  const std::size_t first = set.lines.at(at - reach), last = set.lines.at(at + reach);
  const std::size_t step = 1 + (last - first) / kGainLines;
  std::vector<std::size_t> lines;
  for (std::size_t k = first; k <= last; k += step) lines.push_back(k);
  const auto size = [&](std::size_t i) { return std::abs(channel.frf[lines[i]]); };
  std::size_t largest = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) largest = size(i) > size(largest) ? i : largest;
  const Eigen::MatrixXcd errors = gain_errors(set, channel.point, lines);
  if (errors.size() == 0) return 0;
  const Eigen::VectorXd change = (errors.rowwise() - errors.row(static_cast<Index>(largest))).rowwise().norm();
  double most = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    most = std::max(most, std::sqrt(0.5) * change(static_cast<Index>(i)) * size(i));
  return most;
}

// True where the mode's residue in some FRF is significant, and its peak there is above the error from the force
// channel's noise, a gain that varies with frequency. Each alone can be the noise of the other channel: in a strong FRF
// the force's noise has a significant residue, and in a weak FRF the response's noise exceeds it.
bool above_noise(const WindowedFit& all, const FitGroup& group, std::size_t mode, double least_significance) {
  const FrfDataset& set = all.set();
  const Pole& pole = group.fit.poles[mode];
  for (Index o = 0; o < group.fit.residues.rows(); ++o) {
    if (!(significance(group.fit, o, mode) > least_significance)) continue;
    const FrfChannel& channel = set.channels[static_cast<std::size_t>(o)];
    const double peak = std::abs(group.fit.residues(o, static_cast<Index>(mode))) / (2 * pole.damping_ratio);
    const bool known = !set.points[channel.point].ff.empty();
    const double gain = known ? gain_std(set, channel.point, pole.freq_Hz) : kUnknownGain;
    // A varying gain can turn the flank of a strong mode into a broad peak.
    const double reach = pole.half_power_Hz() / set.lines.df_Hz();
    if (peak > kForceNoise * gain * largest_within(channel.frf, set.lines, pole.freq_Hz, reach)) return true;
    if (known && peak > kForceNoise * changing_gain_error(set, channel, pole.freq_Hz, reach)) return true;
  }
  return false;
}

bool is_broad(const Pole& pole) { return pole.damping_ratio > kBroadDamping; }

// True where a peak lies within the width of this mode. For a broad mode, no other mode may be closer to that peak.
bool began_as_peak(const WindowedFit& all, const Pole& pole, const AcceptanceContext& context) {
  const std::vector<Pole> poles = is_broad(pole) ? all.poles() : std::vector<Pole>{};
  return std::any_of(context.peak_poles.begin(), context.peak_poles.end(), [&](const Pole& peak) {
    const auto apart_Hz = [&](const Pole& from) { return std::abs(peak.freq_Hz - from.freq_Hz); };
    const bool belongs_to_other =
        std::any_of(poles.begin(), poles.end(), [&](const Pole& other) { return apart_Hz(other) < apart_Hz(pole); });
    return apart_Hz(pole) < all.width_Hz(pole) && !belongs_to_other;
  });
}

double min_peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode,
                            const AcceptanceContext& context) {
  const Pole& pole = group.fit.poles[mode];
  const double misfit = std::max(1.0, max_misfit(all, group));
  const bool reached = all.set().usable_bandwidth_Hz <= 0 || pole.freq_Hz <= all.set().usable_bandwidth_Hz;
  // A broad mode can fit the misfit of strong modes over a hundred lines around them.
  const double factor = is_broad(pole) ? misfit : std::min(misfit, kMaxMisfit);
  // During the search, a misfit may belong to a mode that is still to be found.
  return kMinPeakToResidual * (context.search_finished && !began_as_peak(all, pole, context) ? factor : 1) *
         (reached ? 1 : kOutOfBandFactor);
}

// During the search, the residual around a peak may belong to a mode beside it that is still to be found.
double min_significance(const WindowedFit& all, const FitGroup& group, std::size_t mode,
                        const AcceptanceContext& context) {
  const bool may_lack_neighbour = !context.search_finished && began_as_peak(all, group.fit.poles[mode], context);
  return may_lack_neighbour || is_resolved_pair(all, group, mode) ? kMinPairSignificance : kMinSignificance;
}

// An undecayed oscillation may be mains hum, which has a peak but no damping.
bool decays_significantly(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const Pole& pole = group.fit.poles[mode];
  const double left = remaining_amplitude(pole, all.set().lines, all.set().window_decay_per_s());
  return (left > kUndecayedAmplitude ? kMinDampingSignificance : 1) * group.fit.damping_std(static_cast<Index>(mode)) <
         pole.damping_ratio;
}

// True where the damping ratio is below its limit. A precise one may exceed the limit by kDampingMargin standard
// deviations.
bool has_plausible_damping(const FitGroup& group, std::size_t mode) {
  const double damping_ratio = group.fit.poles[mode].damping_ratio;
  const double std = group.fit.damping_std(static_cast<Index>(mode));
  const double margin = std < kPreciseDamping * damping_ratio ? kDampingMargin * std : 0;
  return damping_ratio < kMaxDampingRatio + margin;
}

}  // namespace

double peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const LocalFit& fit = group.fit;
  // The peak's height, or its height on a single line for a mode narrower than the line spacing.
  const double width = std::max(2 * fit.poles[mode].damping_ratio, all.set().lines.df_Hz() / fit.poles[mode].freq_Hz);
  double best = 0;
  for (Index o = 0; o < fit.residues.rows(); ++o) {
    const double peak = std::abs(fit.residues(o, static_cast<Index>(mode))) / width;
    best = std::max(best, fit.noise(o) > 0 ? peak / fit.noise(o) : kInfiniteRatio);
  }
  return best;
}

bool accept_mode(const WindowedFit& all, const FitGroup& group, std::size_t mode, const AcceptanceContext& context) {
  const Pole& pole = group.fit.poles[mode];
  const double low = all.set().lines.freq_Hz(group.first);
  const double high = all.set().lines.freq_Hz(group.first + group.count - 1);
  const auto m = static_cast<Index>(mode);
  const double widest_Hz = kMaxModeWidth * static_cast<double>(all.set().lines.count) * all.set().lines.df_Hz();
  return above_dynamic_range(all, group.fit, mode) &&
         above_noise(all, group, mode, min_significance(all, group, mode, context)) && pole.freq_Hz > low &&
         pole.freq_Hz < high && has_plausible_damping(group, mode) && pole.half_power_Hz() < widest_Hz &&
         peak_to_residual(all, group, mode) > min_peak_to_residual(all, group, mode, context) &&
         group.fit.freq_std_Hz(m) < all.width_Hz(pole) && decays_significantly(all, group, mode);
}

bool poles_coincide(const WindowedFit& all, const Pole& a, const Pole& b) {
  const FrfDataset& set = all.set();
  const bool known = std::any_of(set.points.begin(), set.points.end(), [](const auto& p) { return !p.ff.empty(); });
  const double least_Hz = known ? 0 : set.lines.df_Hz();
  return std::abs(a.freq_Hz - b.freq_Hz) < least_Hz || are_merged(set, a, b);
}

bool accept_all_modes(const WindowedFit& all, const FitGroup& group, const AcceptanceContext& context) {
  const auto& poles = group.fit.poles;
  const double apart = max_misfit(all, group) < kNoiseAlone ? kMinResolvedSplit : kMinSplit;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    if (!accept_mode(all, group, m, context)) return false;
    for (std::size_t i = 0; i < m; ++i) {
      if (poles_coincide(all, poles[i], poles[m])) return false;
      const double a = all.width_Hz(poles[i]);
      const double b = all.width_Hz(poles[m]);
      const double least = apart * std::max(std::min(a, b), 0.5 * std::max(a, b));
      if (std::abs(poles[i].freq_Hz - poles[m].freq_Hz) <= least) return false;
    }
  }
  return true;
}

}  // namespace percuss::identify
