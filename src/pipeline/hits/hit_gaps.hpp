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

/// Adds lost_samples to hits whose pulse has a gap, and to hits whose decay has a gap that can_predict() refuses. The
/// samples of such a decay end before the gap. The finding rejects the hit unless 80 % of its samples remain. Gaps
/// before a pulse do no harm.
void grade_gaps(std::vector<acquire::Hit>& hits, const acquire::Record& record);

/// The gaps that can be predicted, of accepted hits in their order.
std::vector<HitGap> predictable_gaps(const std::vector<AnalysedHit>& hits, const acquire::Record& record);

/// The record with these gaps closed, as far as the predictions fit.
struct ClosedGaps {
  acquire::Record record;
  std::vector<HitGap> gaps;         // all of them
  std::vector<std::size_t> failed;  // indices into `gaps`: straight lines take the place of their samples
};
ClosedGaps close_gaps(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
