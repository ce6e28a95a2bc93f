#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/response/response_test.hpp"
#include "report/html/command_report.hpp"
#include "report/json/analysis_json.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct ResponseReportOptions {
  std::optional<BatLabel> bat{};
  bool charts = false;                                    // the spectra of the decays with the fit
  std::set<ReportSection> sections = default_sections();  // of the document and the tables: hits, modes, classes
};

/// The results of tests without a force: the document percuss/analysis/1 with "input": "response", the tables, and a
/// table of the modes for .csv, whatever the sections. Several tests form an array "runs"; their table of modes begins
/// with a column "test" and ends with a column "file".
CommandReport response_report(const std::vector<pipeline::ResponseTest>& tests,
                              const ResponseReportOptions& options = {});

}  // namespace percuss::report
