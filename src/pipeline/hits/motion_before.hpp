#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"

namespace percuss::pipeline {

/// [hits] whether the structure moves before the impact, so that an integral of its acceleration from there begins with
/// a wrong velocity. It moves where ResponseGrade::may_ring_before says so, or where a long rest after the last blow in
/// the row holds more than white noise.
/// hits  indices into `impacts`
std::vector<bool> moves_before(const acquire::Record& record, const std::vector<AnalysedHit>& impacts,
                               const std::vector<std::size_t>& hits, std::size_t threads);

}  // namespace percuss::pipeline
