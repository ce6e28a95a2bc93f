#pragma once
#include <set>
#include <string>

#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "report/html/command_report.hpp"
#include "report/html/page_elements.hpp"
#include "report/html/trust_section.hpp"
#include "report/text/report_sections.hpp"

namespace percuss::report {

struct PageOptions {
  std::set<ReportSection> sections = default_sections();  // only these are computed
  const pipeline::ImpactTest* deflection = nullptr;
  const CommandReport* comparison = nullptr;  // with other documents
};

/// The analysis as a self-contained page: the result in a sentence, the modes with ±, the warnings, then plots of FRFs,
/// the fit, hits, the barrel's cross-section, mode indicators and stabilisation; then method and provenance.
std::string analysis_page(const pipeline::Analysis& analysis, const PageOptions& options, const Provenance& provenance);

// Sections that other pages use, too.
std::string frf_section(const std::string& summary);
std::string fit_section(const pipeline::Analysis& analysis, const PageWarnings& warnings);
std::string indicator_section(const pipeline::Analysis& analysis);
std::string stabilisation_section(const PageWarnings& warnings);
std::string hits_section(const pipeline::Analysis& analysis, const PageWarnings& warnings);
/// The parts of a page that hits_section shows.
std::set<PagePart> parts_of_hits();

/// Explains the struck-through values in a table of modes; empty where there are none.
std::string quoted_modes_key(const std::vector<identify::ModeClassification>& classifications);

}  // namespace percuss::report
