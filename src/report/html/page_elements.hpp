#pragma once
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "report/html/title_block.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// The provenance of a page, and what its user states. Nothing else on the page depends on time or machine.
struct Provenance {
  std::string command;  // the command line
  std::string made_at;  // UTC, "2026-11-22 21:45"
  TitleBlock title_block{};
};

// Elements of a page's body, as HTML. Plain texts are escaped here.

/// A section under a heading; `content` is HTML.
std::string page_section(const char* id, const char* heading, const std::string& content);
std::string page_paragraph(const std::string& text);
/// How to use a picture on a screen; paper leaves it out.
std::string page_hint(const std::string& text);
/// A figure for the scripts in src/report/html/page to draw in, with a text for screen readers.
std::string page_plot(const char* kind, const std::string& description);
/// The same for a figure with controls, which a screen reader must reach.
std::string page_panel(const char* kind, const std::string& description);
/// A figure with a chart.
std::string page_chart(const LineChart& chart);
std::string page_warnings(const std::vector<pipeline::Warning>& warnings);
/// Version, command and input files. `folded`: for a page whose scripts unfold them on paper.
std::string page_provenance(const std::vector<acquire::InputFile>& files, const Provenance& provenance,
                            bool folded = true);
/// A heading for files: the name of the first without its folder, with "and 3 more".
std::string file_list_title(const std::vector<std::string>& paths);
/// The same for the files of a record.
std::string title_of(const std::vector<acquire::InputFile>& files);

}  // namespace percuss::report
