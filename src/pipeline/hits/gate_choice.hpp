#pragma once
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_spectra.hpp"

namespace percuss::pipeline {

/// Whether an accepted hit has a tail or ringing after its pulse.
bool any_tail(const std::vector<AnalysedHit>& hits);

/// Cuts the tail and ringing of all hits off where the pulses alone explain the responses better: hits of one point
/// then predict each other's responses with less error. One choice for the test: it has one hammer.
void choose_gate(std::vector<AnalysedHit>& hits, const HitResponses& responses, const TransformOptions& options);

}  // namespace percuss::pipeline
