#pragma once
#include <cstddef>
#include <vector>

#include "pipeline/impact_test.hpp"

namespace percuss::pipeline {

/// The beginning of the contact, from the hit's first sample.
double onset_from_first_sample_s(const acquire::Hit& hit, double fs_Hz);

/// The speeds of the balls, from the light beam to the first touch. The touch lies between two samples
/// (metrics::impact_onset): of the force, or of the accelerometer that moves first. Empty without the beam's distance.
/// hits  indices into `impacts`
/// errors  InputError: an impact less than one sample after the light beam.
std::vector<ImpactSpeed> impact_speeds(const Analysis& analysis, const std::vector<AnalysedHit>& impacts,
                                       const std::vector<std::size_t>& hits, const ImpactTestOptions& options);

}  // namespace percuss::pipeline
