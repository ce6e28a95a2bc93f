#pragma once
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// Finds clipping that no single hit shows, because the peaks of a fast mode hold only a sample or two. An extreme
/// sample of a response is a clipping level in two cases: several hits share it, which is improbable by chance at
/// the recorder's resolution; or the opposite extreme has the same magnitude. Sets clipped_samples of each response
/// whose extreme is such a level.
void grade_repeated_clipping(std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
