#include "identify/select/mode_acceptance.hpp"

#include <algorithm>
#include <cmath>

#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMinSignificance = 6;      // deviations of a residue
constexpr double kPair = 0.3;               // bandwidths between two so close that they share it …
constexpr double kMinPairSignificance = 3;  // … and then this many
constexpr double kMinPeakToResidual = 3;    // a mode's peak over the rms residual of its window
constexpr double kMaxMisfit = 8;            // times: a mode 24 times the residual is one however poor the fit
constexpr double kBroadDamping = 0.05;      // … unless it is broader than this
constexpr double kOutOfBandFactor = 12;  // times: in the side lobes of the force's spectrum small peaks are not modes
constexpr double kMaxModeWidth =
    0.25;  // of all lines: a wider half-power bandwidth is not told from what lies between modes
constexpr double kForceNoise = 8;  // deviations of the gain that the force's noise causes
constexpr double kUnknownGain =
    1e-3;  // its deviation where the force is not known: a good hammer's, near its bandwidth
constexpr double kDynamicRange =
    1e-5;                          // of the largest line: smaller peaks cannot be told from what the polynomial leaves
constexpr double kMinSplit = 0.5;  // bandwidths between two modes when one is split …
constexpr double kMinResolvedSplit = 0.05;  // … and when the two leave nothing but noise
constexpr double kNoiseAlone = 1.5;         // times the lines' roughness, which a resonance that moves never comes near
constexpr double kCoincide = 0.05;          // … below which a fit has pushed two into one
constexpr double kUndecayedAmplitude = 0.5;    // of the amplitude, at the record's end: hum is there with all of it
constexpr double kMinDampingSignificance = 3;  // deviations of the damping of what is still there: that of hum is none
constexpr double kPreciseDamping = 0.05;       // deviation of a damping ratio over it …
constexpr double kDampingMargin = 2;           // … and how many of them a broad mode's may read too high
constexpr double kInfiniteRatio = 1e9;         // a quotient over no noise at all

double max_misfit(const WindowedFit& all, const FitGroup& group) {
  return group.fit.noise.cwiseQuotient(all.noise(group)).maxCoeff();
}

double significance(const LocalFit& fit, std::size_t mode) {
  double best = 0;
  for (Index o = 0; o < fit.residues.rows(); ++o) {
    const double std = fit.residue_std(o, static_cast<Index>(mode));
    best = std::max(best, std > 0 ? std::abs(fit.residues(o, static_cast<Index>(mode))) / std : kInfiniteRatio);
  }
  return best;
}

// One of a close pair that leaves nothing but noise: each residue is known badly, because the other can stand for most
// of it; that there are two is known better.
bool is_resolved_pair(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const Pole& pole = group.fit.poles[mode];
  const auto beside = [&](const Pole& other) {
    return &other != &pole &&
           std::abs(other.freq_Hz - pole.freq_Hz) < std::min(all.width_Hz(other), all.width_Hz(pole));
  };
  return max_misfit(all, group) < kNoiseAlone && std::any_of(group.fit.poles.begin(), group.fit.poles.end(), beside);
}

// Above the fit's own imperfection at some channel.
bool above_dynamic_range(const WindowedFit& all, const LocalFit& fit, std::size_t mode) {
  for (Index o = 0; o < fit.residues.rows(); ++o) {
    const double peak = std::abs(fit.residues(o, static_cast<Index>(mode))) / (2 * fit.poles[mode].damping_ratio);
    if (peak > kDynamicRange * all.largest()(o)) return true;
  }
  return false;
}

// Of an FRF, within so many lines of a frequency.
double largest_within(const std::vector<Complex>& frf, const frf::LineRange& lines, double freq_Hz, double reach) {
  const double at = lines.position(freq_Hz);
  double largest = 0;  // as power
  for (std::size_t k = lines.at(at - reach); k <= lines.at(at + reach); ++k)
    largest = std::max(largest, std::norm(frf[k]));
  return std::sqrt(largest);
}

// Above what the force channel's own noise makes of the response there: a gain that wavers with frequency.
bool above_force_noise(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const FrfDataset& set = all.set();
  const Pole& pole = group.fit.poles[mode];
  for (Index o = 0; o < group.fit.residues.rows(); ++o) {
    const FrfChannel& channel = set.channels[static_cast<std::size_t>(o)];
    const double peak = std::abs(group.fit.residues(o, static_cast<Index>(mode))) / (2 * pole.damping_ratio);
    const bool known = !set.points[channel.point].ff.empty();
    const double gain = known ? gain_deviation(set, channel.point, pole.freq_Hz) : kUnknownGain;
    // A gain may waver so as to make a broad mode of the flank of a large one.
    const double reach = pole.half_power_Hz() / set.lines.df_Hz();
    if (peak > kForceNoise * gain * largest_within(channel.frf, set.lines, pole.freq_Hz, reach)) return true;
  }
  return false;
}

bool is_broad(const Pole& pole) { return pole.damping_ratio > kBroadDamping; }

// It began as a peak of its own. One broader than the distance between peaks has those of others within its width.
bool began_as_peak(const WindowedFit& all, const Pole& pole, const AcceptanceContext& context) {
  const std::vector<Pole> poles = is_broad(pole) ? all.poles() : std::vector<Pole>{};
  return std::any_of(context.peak_poles.begin(), context.peak_poles.end(), [&](const Pole& peak) {
    const auto apart_Hz = [&](const Pole& from) { return std::abs(peak.freq_Hz - from.freq_Hz); };
    const bool anothers =
        std::any_of(poles.begin(), poles.end(), [&](const Pole& other) { return apart_Hz(other) < apart_Hz(pole); });
    return apart_Hz(pole) < all.width_Hz(pole) && !anothers;
  });
}

double min_peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode,
                            const AcceptanceContext& context) {
  const Pole& pole = group.fit.poles[mode];
  const double misfit = std::max(1.0, max_misfit(all, group));
  const bool reached = all.set().usable_bandwidth_Hz <= 0 || pole.freq_Hz <= all.set().usable_bandwidth_Hz;
  // A broad one bends to whatever strong modes leave for a hundred lines around them.
  const double counted = is_broad(pole) ? misfit : std::min(misfit, kMaxMisfit);
  // Before the set of modes has settled a misfit may be another mode's, still to be found.
  return kMinPeakToResidual * (context.search_finished && !began_as_peak(all, pole, context) ? counted : 1) *
         (reached ? 1 : kOutOfBandFactor);
}

// What rings on as it began may be hum, which leaves a line but no decay.
bool decays_significantly(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const Pole& pole = group.fit.poles[mode];
  const double left = remaining_amplitude(pole, all.set().lines, all.set().window_decay_per_s());
  return (left > kUndecayedAmplitude ? kMinDampingSignificance : 1) * group.fit.damping_std(static_cast<Index>(mode)) <
         pole.damping_ratio;
}

// Not too broad for a mode, or not beyond doubt.
bool has_plausible_damping(const FitGroup& group, std::size_t mode) {
  const double damping_ratio = group.fit.poles[mode].damping_ratio;
  const double std = group.fit.damping_std(static_cast<Index>(mode));
  const double doubt = std < kPreciseDamping * damping_ratio ? kDampingMargin * std : 0;
  return damping_ratio < kMaxDampingRatio + doubt;
}

}  // namespace

double peak_to_residual(const WindowedFit& all, const FitGroup& group, std::size_t mode) {
  const LocalFit& fit = group.fit;
  // The peak's height, or what a single line sees of a mode narrower than that.
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
  return above_dynamic_range(all, group.fit, mode) && above_force_noise(all, group, mode) && pole.freq_Hz > low &&
         pole.freq_Hz < high && has_plausible_damping(group, mode) && pole.half_power_Hz() < widest_Hz &&
         significance(group.fit, mode) >
             (is_resolved_pair(all, group, mode) ? kMinPairSignificance : kMinSignificance) &&
         peak_to_residual(all, group, mode) > min_peak_to_residual(all, group, mode, context) &&
         group.fit.freq_std_Hz(m) < all.width_Hz(pole) && decays_significantly(all, group, mode);
}

bool poles_coincide(const WindowedFit& all, const Pole& a, const Pole& b) {
  const FrfDataset& set = all.set();
  const bool known = std::any_of(set.points.begin(), set.points.end(), [](const auto& p) { return !p.ff.empty(); });
  const double least_Hz = known ? 0 : set.lines.df_Hz();
  return std::abs(a.freq_Hz - b.freq_Hz) < std::max(least_Hz, kCoincide * std::min(all.width_Hz(a), all.width_Hz(b)));
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
