#pragma once
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/mode.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Warns of groups of points whose accepted hits have a median force that is at least 25 times smaller or larger than
/// in the group of most points. In ascending order of force, a factor of more than 10 between two points separates two
/// groups.
///   units_differ  the responses do not differ in the same direction by a factor of 10 or more, so that the force has
///                 another unit or scale there
///   weak          the forces are smaller, and the responses are smaller by a factor of 10 or more
/// Empty where the responses were not read, and for a test of one point.
std::vector<Warning> point_force_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                          const PointNames& names);

/// units_differ: points whose force was measured with another range or gain. Their median force differs from the
/// others' by a factor of 5 or more, with pulses of the same length (within 30 %), and the modes contradict a soft or
/// hard blow. If the force is smaller, at least two modes move 2.5 times more per newton there than at any other point.
/// If it is larger, no mode reaches a fifth of its largest amplitude there. At least two thirds of the points, and at
/// least six, must have about the same force, and three modes must show clearly.
std::vector<Warning> point_range_warnings(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                          const std::vector<identify::Mode>& modes, const PointNames& names);

}  // namespace percuss::pipeline
