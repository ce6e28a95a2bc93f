#pragma once
#include <span>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// Measures the noise and the baseline of a response before and after its hit, and finds a long dropout.
void examine_response(HitResponse& response, const acquire::Hit& hit, std::span<const double> accel_mps2);

/// Searches the responses for faults of the recording: wrong or missing samples, a moving baseline, and tones. Reads
/// the responses of the hits concerned again, corrects them, and grades and transforms them again.
void correct_responses(HitResponses& responses, const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                       const TransformOptions& options);

/// `channels` with their wrong samples replaced and their missing samples inserted; lengths stay.
std::vector<std::vector<double>> repaired(std::span<const std::span<const double>> channels,
                                          const std::vector<SampleFault>& faults);

}  // namespace percuss::pipeline
