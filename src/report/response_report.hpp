#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/html/command_report.hpp"
#include "report/json/analysis_json.hpp"

namespace percuss::report {

/// The results of tests without a force: the document percuss/analysis/1 with "input": "response", the tables, and a
/// table of the modes for .csv. Several tests form an array "runs". With `charts`: the spectra of the decays with the
/// fit.
CommandReport response_report(const std::vector<pipeline::ResponseTest>& tests, const std::optional<BatLabel>& bat = {},
                              bool charts = false);

}  // namespace percuss::report
