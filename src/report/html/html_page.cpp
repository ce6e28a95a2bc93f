#include "report/html/html_page.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "report/html/page_assets.hpp"
#include "report/text/digest.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

std::string source_of(const std::string& text) { return "'sha256-" + base64(sha256(text)) + "'"; }

// JSON within a script element must not contain "<", which could end the element.
std::string data_text(const std::string& json) {
  std::string out;
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&') {
      out += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : "\\u0026";
    } else {
      out += c;
    }
  }
  return out;
}

std::string paper_style(const TitleBlock& block) {
  return fmt::format(
      ":root {{ --print-width: {}; }}\n@page {{ size: {}; margin: 15mm; @bottom-right {{ content: counter(page) \" / "
      "\" counter(pages); font: 8pt sans-serif; }} }}\n",
      block.print_width, block.paper);
}

}  // namespace

std::string page_title(const std::string& name, const TitleBlock& block) {
  return (block.title.empty() ? name : one_line(block.title, 400)) + " – percuss";
}

std::string HtmlPage::text() const {
  const bool draws = !data.empty();
  const std::string style =
      (draws ? std::string(page_assets().plot_style) : "") + std::string(page_assets().style) + paper_style(block);
  std::string program(page_assets().plot_program);
  for (const std::string_view script : page_assets().program) program += script;
  const std::string scripts = draws ? fmt::format(R"(<script type="application/json" id="data">{}</script>
<script>{}</script>
)",
                                                  data_text(data), program)
                                    : "";
  return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; base-uri 'none'; form-action 'none'; script-src {}; style-src {}{}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{}</title>
<style>{}</style>
</head>
<body>
{}{}</body>
</html>
)",
                     draws ? source_of(program) : "'none'", source_of(style),
                     block.logo.empty() ? "" : "; img-src data:", html_escape(title), style, body, scripts);
}

}  // namespace percuss::report
