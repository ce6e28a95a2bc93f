#include "report/html/page_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/digest.hpp"
#include "report/text/html_escape.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

// The SHA-256 of an input. A dash for standard input, and for a file that cannot be read or whose length has changed.
std::string digest_of(const acquire::InputFile& file) {
  std::error_code error;
  const bool same = file.path != "-" && std::filesystem::file_size(file.path, error) == file.bytes && !error;
  const std::string digest = same ? sha256_of_file(file.path) : "";
  return digest.empty() ? "–" : digest;
}

}  // namespace

std::string page_section(const char* id, const char* heading, const std::string& content) {
  return fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-h\">\n<h2 id=\"{0}-h\">{1}</h2>\n{2}</section>\n", id,
                     heading, content);
}

std::string file_list_title(const std::vector<std::string>& paths) {
  if (paths.empty()) return "";
  const std::string first =
      paths.front() == "-" ? input_name("-") : std::filesystem::path(paths.front()).filename().string();
  const std::string name = one_line(first, 400);
  return paths.size() > 1 ? fmt::format("{} and {} more", name, paths.size() - 1) : name;
}

std::string title_of(const std::vector<acquire::InputFile>& files) {
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (const acquire::InputFile& file : files) paths.push_back(file.path);
  return file_list_title(paths);
}

std::string page_paragraph(const std::string& text) { return "<p>" + html_escape(text) + "</p>\n"; }

std::string page_hint(const std::string& text) { return "<p class=\"hint\">" + html_escape(text) + "</p>\n"; }

namespace {

std::string figure_html(const char* kind, const char* role, const std::string& description) {
  return fmt::format("<figure class=\"picture\" data-plot=\"{}\" role=\"{}\" aria-label=\"{}\"></figure>\n", kind, role,
                     html_escape(description));
}

}  // namespace

std::string page_plot(const char* kind, const std::string& description) {
  return figure_html(kind, "img", description);
}

std::string page_panel(const char* kind, const std::string& description) {
  return figure_html(kind, "group", description);
}

std::string page_chart(const LineChart& chart) {
  return "<figure class=\"picture chart\">\n" + line_chart_svg(chart, ChartTheme::page) + "</figure>\n";
}

std::string page_warnings(const std::vector<pipeline::Warning>& warnings) {
  std::string items;
  for (const pipeline::Warning& warning : warnings)
    items += "<li>" + html_escape(one_line(warning.message, 4000)) + "</li>\n";
  return items.empty() ? "" : "<ul class=\"warnings\" aria-label=\"Warnings\">\n" + items + "</ul>\n";
}

std::string page_provenance(const std::vector<acquire::InputFile>& inputs, const Provenance& provenance, bool folded) {
  TextTable files({{"input"}, {"bytes", TextTable::Align::right}, {"SHA-256"}});
  for (const acquire::InputFile& file : inputs)
    files.add({one_line(input_name(file.path), 400), fmt::format("{}", file.bytes), digest_of(file)});
  return std::string(folded ? "<details>" : "<details open>") +
         "\n<summary>Version, command and input files</summary>\n" +
         page_paragraph(fmt::format("percuss {}, {} UTC", version(), provenance.made_at)) + "<pre>" +
         html_escape(one_line(provenance.command, 4000)) + "</pre>\n" + (inputs.empty() ? "" : files.html()) +
         "</details>\n";
}

}  // namespace percuss::report
