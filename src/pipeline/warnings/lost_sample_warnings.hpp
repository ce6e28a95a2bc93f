#pragma once
#include <string>
#include <vector>

#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/hit_gaps.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// A gap in the samples of a hit, for lost_samples_warning().
struct LostSamples {
  std::size_t hit = 0;
  std::size_t count = 0;
  double after_s = 0;      // from the blow to the gap; 0: within the pulse or just beside it
  bool predicted = false;  // samples predicted from both sides take their place
};

/// lost_samples: the times in the file show that samples are missing. `rest`: the end of the sentence about samples
/// that cannot be predicted. Empty for an empty list.
std::vector<Warning> lost_samples_warning(const std::vector<LostSamples>& lost, const std::string& rest);

/// lost_samples for the accepted hits of a test with a force.
std::vector<Warning> closed_gap_warnings(const ClosedGaps& closed, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
