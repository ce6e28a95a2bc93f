#include "pipeline/warnings/mode_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/counted_words.hpp"
#include "core/io/significant_digits.hpp"
#include "core/math/statistics.hpp"
#include "identify/select/crowded_fit.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kHarmlessShift = 1e-6;       // of a frequency: 0.01 K changes one of steel as much
constexpr double kMaxBesideDrift = 0.1;       // of the variance between points: left by a drift that explains it
constexpr double kVague = 0.5;                // half-power bandwidths: the ± of a mode that is hardly known
constexpr double kMinJointResidual = 0.01;    // relative: below, the model's own approximations may cause it
constexpr double kWorthNaming = 10;           // residual energy of the joint fit over the local fit's
constexpr std::size_t kMaxListedEntries = 8;  // modes, peaks or poles in one warning
constexpr double kMaxSplitBandwidths = 5;     // separation of two peaks that asymmetry or damage splits
constexpr double kClearDamping = 0.1;         // of damping and bandwidth: the ± of a clear mode below the band
constexpr double kMaxDampingBelow = 0.1;      // drift and the baseline make broader ones
constexpr double kToneLines = 2;              // from a tone to the peak that it leaves
constexpr double kToneWanders = 0.01;         // of the frequency: the same for a tone that wanders

// Of FRFs that were given. Noise of the whole record scatters an FRF around each resonance, where the force is small
// beside it.
constexpr const char* kForceNoise = "the noise of the force, if it had no force window";

const char* separator(const std::string& list) { return list.empty() ? "" : ", "; }

// The end of a list that names the first kMaxListedEntries of `count` entries.
std::string and_more(std::size_t count) {
  return count > kMaxListedEntries ? fmt::format(" and {} more", count - kMaxListedEntries) : "";
}

std::string peak_list(const std::vector<identify::UnmodelledPeak>& peaks) {
  std::string list;
  for (std::size_t p = 0; p < std::min(peaks.size(), kMaxListedEntries); ++p)
    list += fmt::format("{}{:.6g} Hz ({:.0f} dB)", separator(list), peaks[p].freq_Hz, peaks[p].level_dB);
  if (peaks.size() > kMaxListedEntries) list += fmt::format(" and {} lower ones", peaks.size() - kMaxListedEntries);
  return list;
}

// Whether a peak lies at a tone, or at a harmonic of a tone of the mains.
bool is_of_a_tone(double freq_Hz, const std::vector<Tone>& tones, double df_Hz) {
  return std::any_of(tones.begin(), tones.end(), [&](const Tone& tone) {
    const double reach_Hz = std::max(kToneLines * df_Hz, tone.wanders ? kToneWanders * tone.freq_Hz : 0);
    const double order = may_be_mains(tone.freq_Hz) ? std::max(1.0, std::round(freq_Hz / tone.freq_Hz)) : 1;
    return std::abs(freq_Hz - order * tone.freq_Hz) < reach_Hz;
  });
}

// The variance of the frequency between the points after the drift is taken off, over the variance before. Points weigh
// by the square of the mode's motion there: near a node, noise moves the pole. 1 where too few points are known.
double variance_beside_drift(const identify::Mode& mode, double change_per_hit, const std::map<int, double>& order) {
  struct Point {
    double weight = 0, freq = 0;  // relative to the mode's
  };
  std::map<int, Point> points;
  for (const identify::Residue& residue : mode.residues) {
    if (!residue.own_pole) continue;
    Point& point = points[static_cast<int>(residue.point)];
    point.weight += std::norm(residue.value);
    point.freq = residue.own_pole->freq_Hz / mode.pole.freq_Hz - 1;
  }
  const auto variance = [&](double per_hit) {
    double weights = 0, sum = 0, squares = 0;
    for (const auto& [number, point] : points) {
      const auto at = order.find(number);
      if (at == order.end()) continue;
      const double value = point.freq - per_hit * at->second;
      weights += point.weight;
      sum += point.weight * value;
      squares += point.weight * value * value;
    }
    return weights > 0 ? squares / weights - std::pow(sum / weights, 2) : 0;
  };
  const double before = variance(0);
  return before > 0 ? variance(change_per_hit) / before : 1;
}

}  // namespace

std::vector<Warning> force_noise_warnings(const std::vector<identify::Mode>& modes) {
  if (modes.empty()) return {};
  return {with_remedy(
      {"force_noise_unknown",
       "FRFs do not contain the noise of the force: each ± includes the response's noise alone, and is too small "
       "where the force's noise is larger, or where the modes differ from hit to hit"},
      "analyse the records if they exist")};
}

std::map<int, double> order_of_points(const std::vector<AnalysedHit>& hits) {
  std::map<int, double> mean;
  std::map<int, std::size_t> count;
  double number = 0;
  for (const std::size_t h : accepted_hits(hits)) {
    double& of_point = mean[hits[h].point];
    of_point += (number++ - of_point) / static_cast<double>(++count[hits[h].point]);
  }
  return mean;
}

std::vector<Warning> freq_scatter_warnings(const std::vector<identify::Mode>& modes, const std::map<int, double>& order,
                                           bool force_known) {
  std::vector<double> drifts;
  for (const identify::Mode& mode : modes) {
    if (mode.drift) drifts.push_back(mode.drift->freq_change_per_hit);
  }
  const bool drifting = !drifts.empty();
  const double usual_drift = median(std::move(drifts));
  std::string list;
  for (const identify::Mode& mode : modes) {
    if (!(mode.freq_scatter_Hz > kHarmlessShift * mode.pole.freq_Hz)) continue;
    const double per_hit = mode.drift ? mode.drift->freq_change_per_hit : usual_drift;
    if (drifting && variance_beside_drift(mode, per_hit, order) < kMaxBesideDrift) continue;
    list += fmt::format("{}{:.1f} Hz (by {:.2g} Hz)", separator(list), mode.pole.freq_Hz, mode.freq_scatter_Hz);
  }
  if (list.empty()) return {};
  return {with_remedy({"moving_modes", "natural frequencies differ from point to point: " + list +
                                           (drifting ? ". The drift from hit to hit does not explain this" : "") +
                                           ". The means over the points are quoted, and their ± includes the "
                                           "scatter. Possible causes: " +
                                           (force_known ? "" : std::string(kForceNoise) + ", ") +
                                           "temperature, the strength of the hits, a sensor that was moved"},
                      force_known
                          ? "measure all points in one session, with equal hits and fixed sensors"
                          : "use a force window, and measure all points in one session, with equal hits and fixed "
                            "sensors")};
}

std::vector<Warning> local_fit_warnings(const std::vector<identify::Mode>& modes, bool force_known) {
  std::string list;
  std::size_t count = 0, unsettled = 0;
  for (const identify::Mode& mode : modes) {
    if (!(mode.joint_misfit > kWorthNaming)) continue;
    if (std::isfinite(mode.joint_misfit) && mode.joint_residual < kMinJointResidual) continue;
    ++count;
    if (!std::isfinite(mode.joint_misfit)) {
      ++unsettled;
    } else if (count - unsettled <= kMaxListedEntries) {
      list +=
          fmt::format("{}{:.1f} Hz ({} times)", separator(list), mode.pole.freq_Hz, significant(mode.joint_misfit, 2));
    }
  }
  if (count == 0) return {};
  list += and_more(count - unsettled);
  const std::string values =
      " Each of them is fitted over the lines around it: its values are valid within their ±, which is somewhat larger "
      "than in a joint fit";
  if (list.empty()) {
    return {with_remedy(
        {"local_fits",
         fmt::format("{} of {} modes keep their local fits, because the fit of all modes together did not converge.{}",
                     count, modes.size(), values),
         {"band"}},
        "analyse a narrower band around these modes for a smaller ±")};
  }
  return {with_remedy(
      {"local_fits",
       fmt::format(
           "around {} of {} modes, all modes together leave at least ten times the residual energy of local "
           "fits: {}.{}. Possible causes: {}a mode that is missing, a strong mode beyond the band, frequencies or "
           "damping that change during the record",
           count, modes.size(), list, values, force_known ? "" : std::string(kForceNoise) + ", "),
       {"band", "start"}},
      "analyse a narrower band around these modes, extend the band past a strong mode beyond it, or state a starting "
      "frequency for a missing one")};
}

std::vector<Warning> no_modes_warnings(const std::vector<identify::Mode>& modes, std::pair<double, double> band_Hz,
                                       bool started) {
  if (!modes.empty()) return {};
  if (started) {
    return {with_remedy({"no_modes", "no mode was found at the starting frequencies", {"start"}},
                        "state frequencies of peaks, or none")};
  }
  return {with_remedy({"no_modes",
                       fmt::format("no mode was found from {:.4g} to {:.4g} Hz: nothing rises above the noise there",
                                   band_Hz.first, band_Hz.second),
                       {"band"}},
                      "check the band, the sensors and the hits")};
}

std::vector<Warning> unmodelled_peak_warnings(std::vector<identify::UnmodelledPeak> peaks,
                                              std::pair<double, double> band_Hz, const std::vector<Tone>& tones,
                                              double df_Hz) {
  std::erase_if(peaks, [&](const identify::UnmodelledPeak& peak) {
    return peak.freq_Hz < band_Hz.first || peak.freq_Hz > band_Hz.second;
  });
  const auto rest = std::stable_partition(peaks.begin(), peaks.end(), [&](const identify::UnmodelledPeak& peak) {
    return !is_of_a_tone(peak.freq_Hz, tones, df_Hz);
  });
  const std::vector<identify::UnmodelledPeak> of_tones(rest, peaks.end());
  peaks.erase(rest, peaks.end());
  std::vector<Warning> out;
  if (!peaks.empty()) {
    out.push_back(with_remedy(
        {"unclaimed_peaks",
         "no mode models these peaks: " + peak_list(peaks) +
             ". A single mode does not fit them well enough. Two modes that are one or two spectral lines apart may "
             "fit them",
         {"start"}},
        "state a starting frequency for each"));
  }
  if (!of_tones.empty()) {
    out.push_back(with_remedy(
        {"unclaimed_peaks", "no mode models these peaks at the frequencies of tones: " + peak_list(of_tones) +
                                ". They are what the removal of hum or of a machine's tone left, rather than modes"},
        "remove the source of the tones, and measure again"));
  }
  return out;
}

bool is_split_hoop(const std::vector<identify::Mode>& modes,
                   const std::vector<identify::ModeClassification>& classifications, std::size_t m) {
  const auto& pair = classifications[m].split_mode;
  const auto hoop = [&](std::size_t i) { return classifications[i].type == identify::ModeType::hoop; };
  const auto bandwidth_Hz = [&](std::size_t i) { return modes[i].pole.half_power_Hz(); };
  if (!pair || !hoop(m) || !hoop(pair->partner)) return false;
  return pair->separation_Hz <= kMaxSplitBandwidths * std::max(bandwidth_Hz(m), bandwidth_Hz(pair->partner));
}

std::vector<Warning> unmodelled_pole_warnings(std::vector<identify::Pole> poles, std::pair<double, double> band_Hz) {
  std::erase_if(
      poles, [&](const identify::Pole& pole) { return pole.freq_Hz < band_Hz.first || pole.freq_Hz > band_Hz.second; });
  if (poles.empty()) return {};
  const std::string list = limited_list(poles.size(), kMaxListedEntries, [&](std::size_t p) {
    return fmt::format("{:.6g} Hz ({:.2g} %)", poles[p].freq_Hz, 100 * poles[p].damping_ratio);
  });
  return {with_remedy({"unmodelled_poles",
                       "stabilisation diagrams of sections of the band show stable poles that no mode describes: " +
                           list + ". Modes may be missing there, and their neighbours may be off by more than their ±",
                       {"band", "start"}},
                      "analyse a narrower band around them, or state a starting frequency for each mode")};
}

std::vector<Warning> below_band_warnings(std::vector<identify::Mode> below, std::pair<double, double> band_Hz) {
  std::erase_if(below, [](const identify::Mode& mode) {
    const bool clear = mode.damping_std < kClearDamping * mode.pole.damping_ratio &&
                       mode.freq_std_Hz < kClearDamping * mode.pole.half_power_Hz();
    return !clear || mode.pole.damping_ratio > kMaxDampingBelow;
  });
  if (below.empty()) return {};
  const std::string list = limited_list(below.size(), kMaxListedEntries,
                                        [&](std::size_t m) { return fmt::format("{:.6g} Hz", below[m].pole.freq_Hz); });
  return {with_remedy({"below_band",
                       fmt::format("{} below the default band, {:.4g} to {:.4g} Hz, and {} not listed: {}",
                                   below.size() == 1 ? "a mode lies" : "modes lie", band_Hz.first, band_Hz.second,
                                   below.size() == 1 ? "is" : "are", list),
                       {"band"}},
                      "state a band that begins lower, unless it is a motion on the suspension")};
}

std::vector<Warning> crowd_warnings(const std::vector<identify::Mode>& modes, std::pair<double, double> band_Hz) {
  std::vector<identify::Pole> poles;
  std::string vague;
  std::size_t count = 0;
  for (const identify::Mode& mode : modes) {
    poles.push_back(mode.pole);
    if (mode.freq_std_Hz < kVague * mode.pole.half_power_Hz() || ++count > kMaxListedEntries) continue;
    vague += fmt::format("{}{:.6g} Hz", separator(vague), mode.pole.freq_Hz);
  }
  const double width_Hz = band_Hz.second - band_Hz.first;
  const bool few_frfs = !modes.empty() && modes.front().residues.size() <= identify::kMaxCrowdFrfs;
  if (!few_frfs || !identify::are_crowded(poles, width_Hz)) return {};
  std::string text = fmt::format(
      "{} modes overlap: together their half-power bandwidths are {:.2g} times as wide as the band. Their number was "
      "chosen by likelihood, and each ± holds for this number; one mode more, or one fewer, moves its neighbours",
      modes.size(), identify::overlap_of(poles, width_Hz));
  if (count > 0) text += ". Known to hardly better than their bandwidth: " + vague + and_more(count);
  return {with_remedy({"crowded", std::move(text), {}}, "measure at more points: their shapes separate close modes")};
}

std::vector<Warning> refused_start_warnings(const std::vector<identify::RefusedStart>& refused) {
  std::vector<Warning> out;
  for (const identify::RefusedStart& at : refused) {
    std::string why;
    switch (at.reason) {
      case identify::RefusedStart::Reason::moved:
        why = fmt::format("the fit moved to {:.6g} Hz, by {:.3g} of its bandwidths", at.pole.freq_Hz,
                          std::abs(at.pole.freq_Hz - at.asked_Hz) / at.pole.half_power_Hz());
        break;
      case identify::RefusedStart::Reason::undamped:
        why = fmt::format("the damping ratio of the fit, {:.2g} ± {:.2g} %, is consistent with zero",
                          100 * at.pole.damping_ratio, 100 * at.damping_std);
        break;
      case identify::RefusedStart::Reason::no_resonance:
        why =
            fmt::format("the fitted peak is only {:.2g} times as high as the residual around it", at.peak_to_residual);
        break;
    }
    out.push_back(
        with_remedy({"start_refused",
                     fmt::format("no mode near {:.6g} Hz: {}. The table has no mode for it", at.asked_Hz, why),
                     {"start"}},
                    "state the frequency of a peak"));
  }
  return out;
}

std::vector<Warning> joined_mode_warnings(const std::vector<identify::JoinedModes>& joined) {
  std::vector<Warning> out;
  for (const identify::JoinedModes& at : joined) {
    const auto [low_Hz, high_Hz] = at.found_Hz;
    out.push_back(
        with_remedy({"start_between",
                     fmt::format("{:.6g} Hz lies between two modes of the search, {:.6g} and {:.6g} Hz: one mode was "
                                 "fitted in their place. If they are two, its values are off by more than their ±",
                                 at.asked_Hz, low_Hz, high_Hz),
                     {"start"}},
                    "state the frequencies of both, unless they are known to be one mode"));
  }
  return out;
}

std::vector<Warning> split_mode_warnings(const std::vector<identify::Mode>& modes,
                                         const std::vector<identify::ModeClassification>& classifications) {
  std::string list;
  for (std::size_t m = 0; m < classifications.size(); ++m) {
    const auto& pair = classifications[m].split_mode;
    if (!pair || !pair->first || !is_split_hoop(modes, classifications, m)) continue;
    list += fmt::format("{}{:.1f} Hz ({} Hz apart)", separator(list), modes[m].pole.freq_Hz,
                        significant(pair->separation_Hz, 3));
  }
  if (list.empty()) return {};
  return {{"double_peak", "split modes, listed by their first peak: " + list +
                              ". Possible causes: a tuned absorber, a crack or other damage, uneven wall or material"}};
}

}  // namespace percuss::pipeline
