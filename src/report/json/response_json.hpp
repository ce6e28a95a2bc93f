#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The document percuss/analysis/1 of tests without a force. Several tests form an array "runs".
std::string responses_json(const std::vector<pipeline::ResponseTest>& tests, const std::optional<BatLabel>& bat = {});

}  // namespace percuss::report
