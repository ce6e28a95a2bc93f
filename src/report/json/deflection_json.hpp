#pragma once
#include <string>
#include <vector>

#include "pipeline/impact_test.hpp"

namespace percuss::report {

/// The document percuss/deflection/1: peaks per hit and channel, means per point, impact speeds, warnings.
std::string deflection_json(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// The document with the modes that the impacts excited ("modes"), and the document percuss/compare/1 of their
/// comparison ("comparison").
std::string with_comparison(const std::string& document, const std::vector<identify::Mode>& modes,
                            const std::string& comparison);

}  // namespace percuss::report
