#pragma once
#include <set>
#include <string>

#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "report/html/command_report.hpp"
#include "report/html/page_elements.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct PageOptions {
  std::set<ReportSection> sections = default_sections();  // nothing else is computed
  const pipeline::ImpactTest* deflection = nullptr;
  const CommandReport* comparison = nullptr;  // with other documents
};

/// The analysis as a page of one file: what was found in a sentence, the modes with their deviations, warnings, then
/// FRFs, hits, the stabilisation diagram and the barrel's movement as pictures, and how it came about.
std::string analysis_page(const pipeline::Analysis& analysis, const PageOptions& options, const Provenance& provenance);

/// The section of the FRFs, and that of the hits, which other pages show as well.
std::string frf_section(const std::string& verdict);
std::string hits_section(const pipeline::Analysis& analysis);

}  // namespace percuss::report
