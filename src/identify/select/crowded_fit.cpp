#include "identify/select/crowded_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/select/joint_fit_budget.hpp"
#include "identify/select/joint_selection.hpp"
#include "identify/start/residual_smoothness.hpp"
#include "identify/start/vector_fitting.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kMinCrowd = 15;  // modes
constexpr double kMinOverlap = 0.2;
// Limits against false crowds: the stable poles of a misfit, of rounding errors or of a recorder's coarse steps cover
// more than the band, or hardly any mode was found one by one.
constexpr double kMaxOverlap = 1;
constexpr std::size_t kMinFound = 5;
constexpr double kHighOverlap = 1;        // from here on, some modes are not well determined
constexpr double kDeterminedShare = 0.9;  // … below, almost all are
constexpr double kFirstCount = 1.5;       // pole pairs of the first trial, over the number of known modes
constexpr double kCountGrowth = 1.3;      // factor of this number from one trial to the next
constexpr std::size_t kMaxCount = 150;
constexpr double kMaxProducts = 5e10;  // of all fits together: about half a minute
constexpr double kCoreShare = 0.1;     // groups around the poles, of a bandwidth
constexpr double kResolution = 0.2;    // of a bandwidth
constexpr double kGainPerUnknown = 5;  // half the logarithm of the number of lines
constexpr double kNeeded = 6;          // standard deviations of a residue
// Loss of likelihood_ratio_statistic() below which a mode that is not well determined is dropped: noise alone gives
// about 1.
constexpr double kLossPerUnknown = 3;
// Standard deviations of the largest residue of a well determined mode.
constexpr double kMinDeterminedSignificance = 3;
constexpr int kCrowdFits = 12;
constexpr int kTrialSteps = 8, kCrowdSteps = 150;  // while poles are dropped; of the last fit
constexpr int kSmallDecreases = 5;                 // steps in a row
constexpr double kCrowdCost = 1e-5;  // relative decrease of the squares: some poles are not well determined

// A fraction of a narrow bandwidth. A few of the known poles may follow noise.
double resolution_Hz(const std::vector<Pole>& known) {
  std::vector<double> widths_Hz;
  widths_Hz.reserve(known.size());
  for (const Pole& pole : known) widths_Hz.push_back(pole.half_power_Hz());
  std::sort(widths_Hz.begin(), widths_Hz.end());
  return kResolution * widths_Hz[widths_Hz.size() / 4];
}

// The largest |residue| of mode m over its standard deviation.
double residue_significance(const JointFit& fit, std::size_t m) {
  const auto at = static_cast<Index>(m);
  return (fit.residues.col(at).cwiseAbs().array() / fit.residue_std.col(at).array()).maxCoeff();
}

// The poles whose residues differ significantly from zero. Unlike a mode of the other searches, a pole need not stand
// out of its neighbours.
std::vector<Pole> needed_poles(const FrfDataset& set, const JointFit& linear) {
  std::vector<Pole> needed;
  for (std::size_t m = 0; m < linear.poles.size(); ++m) {
    const Pole& pole = linear.poles[m];
    const bool repeated =
        std::any_of(needed.begin(), needed.end(), [&](const Pole& k) { return are_merged(set, k, pole); });
    if (!repeated && residue_significance(linear, m) > kNeeded) needed.push_back(pole);
  }
  return needed;
}

double gain_per_unknown(const FrfDataset& set, const JointFit& fewer, const JointFit& more) {
  const std::size_t modes = more.poles.size() > fewer.poles.size() ? more.poles.size() - fewer.poles.size() : 1;
  return likelihood_ratio_statistic(set, fewer.residual, more.residual) /
         static_cast<double>(modes * unknowns_per_mode(set));
}

// The residues at poles from vector fitting. The number of poles grows as long as the likelihood gains enough.
std::optional<JointFit> start_of(const FrfDataset& set, const std::vector<Pole>& known) {
  std::optional<JointFit> best;
  for (double count = kFirstCount * static_cast<double>(known.size()); count <= static_cast<double>(kMaxCount);
       count *= kCountGrowth) {
    const std::vector<Pole> poles = vector_fitting_poles(set, static_cast<std::size_t>(count), resolution_Hz(known));
    if (poles.empty()) break;
    JointFit fit = fit_residues(set, poles);
    if (best && gain_per_unknown(set, *best, fit) < kGainPerUnknown) break;
    best = std::move(fit);
  }
  return best;
}

double band_width_Hz(const FrfDataset& set) { return static_cast<double>(set.lines.count) * set.lines.df_Hz(); }

// A fit of crowded modes leaves only noise. Many poles describe most of the misfit of a few modes, but not all of it.
bool leaves_misfit(const FrfDataset& set, const JointFit& fit) {
  return overlap_of(fit.poles, band_width_Hz(set)) < kHighOverlap && smooth_somewhere(fit.residual);
}

// The fit from these poles. Poles that are not needed are dropped while the fit is still rough. Nothing where the fit
// leaves a misfit.
std::optional<JointFit> converged_fit(const FrfDataset& set, std::vector<Pole> poles, double& products_left) {
  int steps = kTrialSteps;
  std::optional<JointFit> converged;
  for (int round = 0; round < kCrowdFits && !poles.empty(); ++round) {
    JointFit fit = fit_jointly(set, poles,
                               {.max_steps = steps,
                                .cost_tolerance = kCrowdCost,
                                .core_share = kCoreShare,
                                .max_small_decreases = kSmallDecreases,
                                .test_real = false});
    const double columns = estimated_columns(fit.poles);
    products_left -= fit.trials * 2 * static_cast<double>(set.lines.count) * columns * columns;
    if (products_left < 0 || (fit.converged && leaves_misfit(set, fit))) return std::nullopt;
    poles = needed_poles(set, fit_residues(set, fit.poles));
    const bool complete = poles.size() == fit.poles.size();
    const bool is_last = fit.converged ? complete : steps == kCrowdSteps;
    if (fit.converged) converged = std::move(fit);
    if (is_last) break;
    if (complete) steps = kCrowdSteps;
  }
  return converged;
}

// Frequency known to within the bandwidth, damping to within itself, and a significant residue.
bool is_well_determined(const JointFit& fit, std::size_t m) {
  const auto at = static_cast<Index>(m);
  return fit.freq_std_Hz(at) < fit.poles[m].half_power_Hz() && fit.damping_std(at) < fit.poles[m].damping_ratio &&
         residue_significance(fit, m) > kMinDeterminedSignificance;
}

// Drops the modes that are not well determined if the FRFs are as likely without them: all at once, or else one after
// the other, the weakest first.
JointFit without_undetermined(const FrfDataset& set, JointFit fit, double& products_left) {
  for (bool all = true;;) {
    std::vector<Pole> kept;
    std::size_t weakest = fit.poles.size();
    for (std::size_t m = 0; m < fit.poles.size(); ++m) {
      if (is_well_determined(fit, m)) {
        kept.push_back(fit.poles[m]);
      } else if (weakest == fit.poles.size() || residue_significance(fit, m) < residue_significance(fit, weakest)) {
        weakest = m;
      }
    }
    if (weakest == fit.poles.size()) return fit;
    if (!all) {
      kept = fit.poles;
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(weakest));
    }
    std::optional<JointFit> fewer = converged_fit(set, std::move(kept), products_left);
    const bool as_likely = fewer && gain_per_unknown(set, *fewer, fit) < kLossPerUnknown;
    if (!as_likely && !all) return fit;
    if (as_likely) fit = *std::move(fewer);
    all = false;
  }
}

// Modes that overlap little are all well determined, unless they follow a misfit: on wooden plates, only half to three
// quarters of them were.
bool are_determined(const FrfDataset& set, const JointFit& fit) {
  std::size_t determined = 0;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) determined += is_well_determined(fit, m) ? 1U : 0U;
  return overlap_of(fit.poles, band_width_Hz(set)) >= kHighOverlap ||
         static_cast<double>(determined) >= kDeterminedShare * static_cast<double>(fit.poles.size());
}

}  // namespace

double overlap_of(const std::vector<Pole>& poles, double band_width_Hz) {
  double widths_Hz = 0;
  for (const Pole& pole : poles) widths_Hz += pole.half_power_Hz();
  return widths_Hz / band_width_Hz;
}

bool are_crowded(const std::vector<Pole>& poles, double band_width_Hz) {
  return poles.size() >= kMinCrowd && overlap_of(poles, band_width_Hz) > kMinOverlap;
}

std::optional<JointFit> crowded_fit(const FrfDataset& set, const std::vector<Pole>& stable,
                                    const std::vector<Pole>& found) {
  const double width_Hz = band_width_Hz(set);
  const bool likely =
      are_crowded(stable, width_Hz) && overlap_of(stable, width_Hz) < kMaxOverlap && found.size() >= kMinFound;
  if (!likely || set.channels.size() > kMaxCrowdFrfs) return std::nullopt;
  const std::optional<JointFit> start = start_of(set, stable);
  if (!start) return std::nullopt;
  double products_left = kMaxProducts;
  std::optional<JointFit> fit = converged_fit(set, needed_poles(set, *start), products_left);
  if (!fit) return std::nullopt;
  fit = without_undetermined(set, *std::move(fit), products_left);
  return are_crowded(fit->poles, width_Hz) && are_determined(set, *fit) ? std::move(fit) : std::nullopt;
}

}  // namespace percuss::identify
