#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/hit_spectra.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// `aliasing`: the spectra of the pulses and of the responses do not fall towards half the sampling rate, and the
/// pulses do not ring there, as they would behind a steep anti-alias filter.
std::vector<Warning> aliasing_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       const HitResponses& responses);

/// `response_clipped`: extremes of responses that are equal from hit to hit while the forces differ. Where most hits
/// show flat tops (ResponseGrade::clipped_samples), the recorder clips. Otherwise the signal was clipped before the
/// recorder's filter.
std::vector<Warning> analogue_clipping_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                                const HitResponses& responses);

/// The corner in Hz of the force channel's AC coupling that most of these hits agree on; 0 where they do not.
double coupling_corner_Hz(const std::vector<AnalysedHit>& hits, const std::vector<std::size_t>& chosen);

/// `ac_coupling`: the force channel undershoots after each pulse, with a corner frequency that turns the FRFs' phase at
/// `low_Hz`, the low end of the band.
std::vector<Warning> coupling_warnings(const std::vector<AnalysedHit>& hits, double low_Hz);

/// `duplicate`: hits whose pulses and responses are equal in all samples, the noise included. Equal pulses alone are
/// those of one blow whose responses were saved point by point.
std::vector<Warning> duplicate_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
