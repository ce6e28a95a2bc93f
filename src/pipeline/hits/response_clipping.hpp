#pragma once
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Finds clipping that no single hit shows, because the peaks of a fast mode hold only a sample or two. Clipping levels
/// are extreme samples of a channel that are equal in several hits, which is improbable at the recorder's resolution,
/// or that are equal in magnitude on both sides. Sets clipped_samples of each response whose extreme is such a level.
void grade_repeated_clipping(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
