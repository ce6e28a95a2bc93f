#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/json/analysis_json.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

/// The document percuss/analysis/1 of tests without a force, with the chosen of the sections hits, modes and classes.
/// Several tests form an array "runs".
std::string responses_json(const std::vector<pipeline::ResponseTest>& tests, const std::optional<BatLabel>& bat = {},
                           const std::set<ReportSection>& sections = default_sections());

}  // namespace percuss::report
