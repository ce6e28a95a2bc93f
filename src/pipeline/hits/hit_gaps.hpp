#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"
#include "acquire/record/sample_gap.hpp"
#include "pipeline/findings/lost_samples.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// A gap of the record (acquire::gaps_of) in the free decay after a hit.
struct HitGap {
  std::size_t hit = 0;
  GapInDecay at;
};

/// Adds lost_samples to hits whose pulse has a gap, and to hits whose decay has a gap that cannot be predicted
/// (can_predict()). A gap in the pulse rejects the hit. A gap in the decay ends the hit before it, and rejects the hit
/// unless 80 % of its samples remain. Gaps before the pulse have no effect.
void grade_gaps(std::vector<acquire::Hit>& hits, const acquire::Record& record);

/// The gaps that can be predicted, of accepted hits in their order.
std::vector<HitGap> predictable_gaps(const std::vector<AnalysedHit>& hits, const acquire::Record& record);

/// The record with its predictable_gaps() closed.
struct ClosedGaps {
  acquire::Record record;
  std::vector<HitGap> gaps;         // predictable_gaps()
  std::vector<std::size_t> failed;  // indices into `gaps`: the prediction does not fit, and a straight line stays
};
ClosedGaps close_gaps(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
