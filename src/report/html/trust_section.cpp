#include "report/html/trust_section.hpp"

#include <fmt/format.h>

#include "pipeline/warnings/ranking.hpp"
#include "report/html/page_elements.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

using acquire::Severity;

constexpr std::size_t kMaxBytes = 4000;  // of one statement

const char* label_of(Severity severity) {
  switch (severity) {
    case Severity::reject:
      return "Results are wrong";
    case Severity::warn:
      return "Results may be off";
    case Severity::info:
      return "For information";
  }
  return "";
}

// The message without the remedy that ends it.
std::string consequence_of(const pipeline::Warning& warning) {
  const std::string end = "; " + warning.remedy;
  if (warning.remedy.empty() || !warning.message.ends_with(end)) return warning.message;
  return warning.message.substr(0, warning.message.size() - end.size());
}

std::string statement_html(const pipeline::Warning& warning) {
  const Severity severity = warning.severity.value_or(Severity::warn);
  std::string out = fmt::format("<li class=\"{}\"><b>{}.</b> {}", name_of(severity), label_of(severity),
                                html_escape(one_line(consequence_of(warning), kMaxBytes)));
  if (!warning.remedy.empty())
    out += fmt::format(" <span class=\"remedy\">Remedy: {}.</span>", html_escape(one_line(warning.remedy, kMaxBytes)));
  return out + "</li>\n";
}

}  // namespace

std::string trust_section(const std::vector<pipeline::Warning>& warnings,
                          const std::vector<pipeline::AnalysedHit>& hits) {
  std::string items;
  for (const pipeline::Warning& one : pipeline::trust_statements(warnings, hits)) items += statement_html(one);
  const std::string content = items.empty()
                                  ? page_paragraph("Nothing was found that puts the results or their ± in doubt.")
                                  : "<ol class=\"warnings trust\" aria-label=\"Warnings\">\n" + items + "</ol>\n";
  return page_section("trust", "How far can this test be trusted?", content);
}

}  // namespace percuss::report
