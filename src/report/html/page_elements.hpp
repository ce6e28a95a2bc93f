#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// What a page says of how it came about; nothing else on it depends on when and where.
struct Provenance {
  std::string command;  // the command line
  std::string made_at;  // UTC, "2026-11-22 21:45"
};

// Pieces of a page's body, as HTML. Texts are plain, and escaped here.

/// A section under a heading; `content` is HTML.
std::string page_section(const char* id, const char* heading, const std::string& content);
std::string page_paragraph(const std::string& text);
/// A place for src/report/page to draw in, and what it shows in words for those who do not see it.
std::string page_picture(const char* kind, const std::string& description);
/// A chart that is drawn already.
std::string page_chart(const LineChart& chart);
/// What the page is of, and under which conditions.
std::string page_header(const std::string& title, const std::string& conditions);
std::string page_warnings(const std::vector<pipeline::Warning>& warnings);
/// Findings of these kinds, hit by hit, to stand beside the picture that shows them.
std::string page_findings(const pipeline::Analysis& analysis, const std::vector<acquire::FindingCode>& codes);
std::string page_provenance(const std::vector<acquire::InputFile>& files, const Provenance& provenance);
/// Files for a heading: the name of the first without its folder, "and 3 more" with it.
std::string file_list_title(const std::vector<std::string>& paths);
/// The same of what was read.
std::string title_of(const std::vector<acquire::InputFile>& files);

}  // namespace percuss::report
