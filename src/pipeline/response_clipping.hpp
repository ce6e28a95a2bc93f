#pragma once
#include <vector>

#include "pipeline/analysed_hit.hpp"

namespace percuss::pipeline {

/// Finds rails that no hit shows by itself, since a fast mode's tops have a sample or two: the furthest samples of a
/// channel that are one number in several hits, which chance would not bring about at the recorder's resolution, or
/// that lie as far to one side as to the other. Whatever ends at one of them is at a rail: sets clipped_samples.
void grade_repeated_clipping(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
