#pragma once
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Finds clipping that no single hit shows, because the peaks of a fast mode hold only a sample or two. A clipping
/// level is an extreme sample of a channel that several hits share, which is improbable at the recorder's resolution,
/// or that is equal in magnitude on both sides. Sets clipped_samples of each response whose extreme is such a level.
void grade_repeated_clipping(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
