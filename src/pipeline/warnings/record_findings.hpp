#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/hit_spectra.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Warnings about faults of the recording: `lost_samples`, `dropout`, `spike`, `zero_shift`, `offset`, `hum`, `tone`,
/// `already_windowed`, and `response_clipped`, `aliasing` and `duplicate` of force_findings.hpp. Each message states
/// the number that decided, the consequence and the remedy.
std::vector<Warning> record_findings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                     const HitResponses& responses);

std::vector<Warning> fault_warnings(const std::vector<HitFaults>& faults, const acquire::Record& record,
                                    const std::vector<AnalysedHit>& hits);
std::vector<Warning> long_dropout_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                           const HitResponses& responses);
std::vector<Warning> baseline_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       const HitResponses& responses);
std::vector<Warning> tone_warnings(const std::vector<Tone>& tones);
std::vector<Warning> window_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                     const HitResponses& responses);

}  // namespace percuss::pipeline
