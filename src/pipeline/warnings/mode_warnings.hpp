#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/model/mode.hpp"
#include "identify/select/fitted_starts.hpp"
#include "identify/start/unmodelled_peaks.hpp"
#include "identify/started_modes.hpp"
#include "pipeline/findings/tones.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// force_noise_unknown: modes were fitted to FRFs that were given.
std::vector<Warning> force_noise_warnings(const std::vector<identify::Mode>& modes);

/// [points] the mean position of a point's hits in the test: the accepted hits are numbered 0, 1, … in their order.
std::map<int, double> order_of_points(const std::vector<AnalysedHit>& hits);

/// moving_modes: frequencies that differ from point to point, unless the drift over the order of the hits explains 90 %
/// of the variance: `drifting` then names the cause. A mode without a drift of its own has the median of the others'.
/// order        as order_of_points(); empty where the hits are not known
/// force_known  false for FRFs that were given: the noise of their force is not known, and may be the cause
std::vector<Warning> freq_scatter_warnings(const std::vector<identify::Mode>& modes,
                                           const std::map<int, double>& order = {}, bool force_known = true);

/// no_modes: no mode was found. `started`: the user stated starting frequencies.
std::vector<Warning> no_modes_warnings(const std::vector<identify::Mode>& modes, std::pair<double, double> band_Hz,
                                       bool started);

/// unclaimed_peaks: prominent peaks within the band that no mode models.
/// A separate message names the peaks that tones cause. These lie within two lines of a tone (1 % of its frequency if
/// it wanders), or of a harmonic of the mains if there is a tone of the mains.
/// peaks  the largest first.
std::vector<Warning> unmodelled_peak_warnings(std::vector<identify::UnmodelledPeak> peaks,
                                              std::pair<double, double> band_Hz, const std::vector<Tone>& tones,
                                              double df_Hz);

/// Whether mode m and its partner are hoop modes of a tube, closer than a few bandwidths: then damage or asymmetry may
/// have split one mode.
bool is_split_hoop(const std::vector<identify::Mode>& modes,
                   const std::vector<identify::ModeClassification>& classifications, std::size_t m);

/// local_fits: modes around which the joint fit leaves more residual than their local fit.
/// force_known  as for freq_scatter_warnings()
std::vector<Warning> local_fit_warnings(const std::vector<identify::Mode>& modes, bool force_known = true);

/// unmodelled_poles: stable poles within the band whose resonance no mode describes (identify::unmodelled_poles).
std::vector<Warning> unmodelled_pole_warnings(std::vector<identify::Pole> poles, std::pair<double, double> band_Hz);

/// below_band: clear modes just below the default band.
/// below  modes below the band, ascending
std::vector<Warning> below_band_warnings(std::vector<identify::Mode> below, std::pair<double, double> band_Hz);

/// crowded: so many modes overlap in one or two FRFs that their number is a choice.
std::vector<Warning> crowd_warnings(const std::vector<identify::Mode>& modes, std::pair<double, double> band_Hz);

/// start_refused: starting frequencies at which no mode was found, with the reason.
std::vector<Warning> refused_start_warnings(const std::vector<identify::RefusedStart>& refused);

/// start_between: starting frequencies between two close modes of the search, in whose place one mode was fitted.
std::vector<Warning> joined_mode_warnings(const std::vector<identify::JoinedModes>& joined);

/// double_peak: split hoop modes, listed by their first peak.
std::vector<Warning> split_mode_warnings(const std::vector<identify::Mode>& modes,
                                         const std::vector<identify::ModeClassification>& classifications);

}  // namespace percuss::pipeline
