#pragma once
#include <string>

#include "pipeline/impact_test.hpp"

namespace percuss::report {

/// The document percuss/deflection/1: peaks per hit and channel, means per point, impact speeds, warnings.
std::string deflection_json(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

}  // namespace percuss::report
