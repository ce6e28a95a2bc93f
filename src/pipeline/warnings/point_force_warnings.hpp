#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Points whose accepted hits have a median force that is at least 25 times smaller or larger than at most points, with
/// no point in between:
///   units_differ  their responses do not differ as the forces do, so that the force has another unit or scale there
///   weak          the forces are smaller, and the responses nearly as much
/// Empty where the responses were not read, and for a test of one point.
std::vector<Warning> point_force_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits);

}  // namespace percuss::pipeline
