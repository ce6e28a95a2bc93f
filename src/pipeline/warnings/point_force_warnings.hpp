#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Groups of points whose accepted hits have a median force that is at least 25 times smaller or larger than in the
/// largest group. In ascending order of force, a factor of more than 10 lies between the groups:
///   units_differ  their responses differ in this direction by less than a factor of 10, so that the force has another
///                 unit or scale there
///   weak          the forces are smaller, and the responses by a factor of 10 or more, too
/// Empty where the responses were not read, and for a test of one point.
std::vector<Warning> point_force_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                          const PointNames& names);

}  // namespace percuss::pipeline
