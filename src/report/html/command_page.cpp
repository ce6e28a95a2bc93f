#include "report/html/command_page.hpp"

#include <filesystem>
#include <system_error>

#include "report/html/html_page.hpp"
#include "report/html/mac_table.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

std::string title_of(const CommandReport& report, const std::vector<std::string>& inputs) {
  if (!inputs.empty()) return file_list_title(inputs);
  return report.charts.empty() ? "Numbers" : report.charts.front().title;
}

std::vector<acquire::InputFile> files_of(const std::vector<std::string>& inputs) {
  std::vector<acquire::InputFile> files;
  for (const std::string& path : inputs) {
    std::error_code error;
    const std::uint64_t bytes = path == "-" ? 0 : std::filesystem::file_size(path, error);
    files.push_back({.path = path, .bytes = error ? 0 : bytes});
  }
  return files;
}

}  // namespace

std::string command_page(const CommandReport& report, const std::vector<std::string>& inputs,
                         const Provenance& provenance) {
  const std::string title = title_of(report, inputs);
  TitleBlock block = provenance.title_block;
  block.facts.insert(block.facts.begin(), report.facts.begin(), report.facts.end());
  std::string body = page_header(title, "", block) + "<main>\n" + page_section("found", "Result", report.text.html());
  const bool bends = !report.bending.modes.empty();
  if (bends) {
    body += page_section("bending", "Bending modes of the bat",
                         page_plot("bending", "The bat in each of its bending modes."));
  }
  std::string charts;
  for (const LineChart& chart : report.charts) charts += page_chart(chart);
  if (!charts.empty()) body += page_section("charts", "Charts", charts);
  std::string macs;
  for (const MacMatrix& matrix : report.macs) macs += mac_table_html(matrix);
  if (!macs.empty()) body += page_section("mac", "Agreement of the shapes (MAC)", macs);
  body += page_section("provenance", "Provenance", page_provenance(files_of(inputs), provenance, bends)) + "</main>\n";
  return HtmlPage{.title = page_title(title, provenance.title_block),
                  .body = body,
                  .block = provenance.title_block,
                  .data = bends ? "[" + bending_plot_json(report.bending) + "]" : ""}
      .text();
}

}  // namespace percuss::report
