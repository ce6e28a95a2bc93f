#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/hit_spectra.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Whether the reader noted that the FRFs are for exp(−jωt). No mode can be fitted to them.
bool has_reversed_phase(const acquire::Record& record);

/// input: each note of the reader, as a warning. reversed_phase: the note of has_reversed_phase().
std::vector<Warning> input_warnings(const acquire::Record& record);

/// Removes the warnings that follow from reversed phase, because no mode describes such FRFs: missing modes, peaks,
/// poles, residuals and signs.
void remove_consequences_of_reversed_phase(std::vector<Warning>& warnings);

/// What the hits show of one channel.
struct ChannelMotion {
  bool constant = false;  // in a tenth of the accepted hits or more
  // Its largest sample is, in the median over the accepted hits, at least 30 standard deviations of the noise before
  // the hit. False where too few samples before the hits determine the noise.
  bool responds = false;
  bool still = false;  // no sample after an accepted hit exceeds six standard deviations of the noise before it
};
/// [channels] without the tones that were removed
std::vector<ChannelMotion> channel_motions(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                           const HitResponses& responses);

/// Ends the message about a channel that mode types would rest on.
inline constexpr const char* kNoTypesWithoutIt = ". Mode types, which would rest on it, are not stated";

/// dead_channel, coarse_steps, channel by channel. `types_need`: [channels] the channels by which modes are typed
/// (needed_for_types()); empty for none.
std::vector<Warning> channel_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                      const std::vector<bool>& types_need = {});

/// dead_channel for each channel whose samples stay in its noise at every accepted hit. For tests in which no mode was
/// found: a mode can be found even in responses of which no sample rises above the noise.
std::vector<Warning> silent_response_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                              const HitResponses& responses);

/// A channel that stays in its noise at all accepted hits of one point.
struct SilentPoint {
  int point = 0;
  std::size_t channel = 0;
  std::vector<std::size_t> hits;
};
/// The points of a survey at which a channel stays in its noise, although it clearly responds to most hits.
std::vector<SilentPoint> silent_points(const std::vector<AnalysedHit>& hits, const HitResponses& responses);
/// dead_channel for these points.
std::vector<Warning> silent_point_warnings(const acquire::Record& record, const std::vector<SilentPoint>& silent,
                                           const PointNames& names);

}  // namespace percuss::pipeline
