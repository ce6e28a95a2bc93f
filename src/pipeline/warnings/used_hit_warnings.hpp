#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// double_hits_used, force_clipped: hits that are used in spite of their finding. dropped_points: points without an
/// accepted hit. short_hit: one hit cuts the transforms of all hits to `samples`.
std::vector<Warning> used_hit_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                       std::size_t samples, const PointNames& names);

}  // namespace percuss::pipeline
