#include "report/analysis_page.hpp"

#include <fmt/format.h>

#include "acquire/input_file.hpp"
#include "core/error.hpp"
#include "report/analysis_pictures.hpp"
#include "report/analysis_tables.hpp"
#include "report/analysis_verdict.hpp"
#include "report/digest.hpp"
#include "report/html_page.hpp"
#include "report/html_text.hpp"
#include "report/version.hpp"

namespace percuss {
namespace {

std::string section(const char* id, const char* heading, const std::string& content) {
  return fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-h\">\n<h2 id=\"{0}-h\">{1}</h2>\n{2}</section>\n", id,
                     heading, content);
}

std::string paragraph(const std::string& text) { return "<p>" + html_text(text) + "</p>\n"; }

// A place for page.js to draw in, and what it shows in words for those who do not see it.
std::string picture(const char* kind, const std::string& description) {
  return fmt::format("<figure class=\"picture\" data-picture=\"{}\" role=\"img\" aria-label=\"{}\"></figure>\n", kind,
                     html_text(description));
}

std::string warnings_html(const Analysis& analysis) {
  std::string items;
  for (const Warning& warning : analysis.warnings())
    items += "<li>" + html_text(one_line(warning.message, 4000)) + "</li>\n";
  return items.empty() ? "" : "<ul class=\"warnings\" aria-label=\"Warnings\">\n" + items + "</ul>\n";
}

std::string frf_html(const Analysis& analysis) {
  const std::string peaks = verdict_sentence(analysis);
  return paragraph("Drag to enlarge a stretch of frequencies in all three pictures, double-click to see all again.") +
         picture("magnitude", "Magnitude of the frequency responses in decibels over frequency. " + peaks) +
         picture("phase", "Phase of the frequency responses over frequency.") +
         picture("coherence", "Coherence over frequency, 0 to 1.");
}

std::string provenance_html(const Analysis& analysis, const Provenance& provenance) {
  TextTable files({{"input"}, {"bytes", TextTable::Align::right}, {"SHA-256"}});
  for (const InputFile& file : analysis.record().files)
    files.add({one_line(input_name(file.path), 400), fmt::format("{}", file.bytes), sha256_of_file(file.path)});
  return "<details>\n<summary>Method and provenance</summary>\n" +
         paragraph(fmt::format("percuss {}, {} UTC", version(), provenance.made_at)) + "<pre>" +
         html_text(one_line(provenance.command, 4000)) + "</pre>\n" + files.html() + "</details>\n";
}

}  // namespace

std::string analysis_page(const Analysis& analysis, const Provenance& provenance) {
  const std::string name = one_line(input_name(analysis.record().source()), 400);
  const bool with_hits = analysis.given_frfs() == nullptr;
  const std::size_t hits = with_hits ? analysis.hits().size() : 0;
  std::string body = "<header>\n<h1>" + html_text(name) + "</h1>\n<p class=\"conditions\">" +
                     html_text(conditions_of(analysis, hits)) + "</p>\n</header>\n<main>\n";
  std::string found = "<p class=\"verdict\">" + html_text(verdict_sentence(analysis)) + "</p>\n";
  if (analysis.possible() && !analysis.modes().empty()) found += modes_table(analysis, true).html();
  body += section("modes", "Modes", found + warnings_html(analysis));
  if (analysis.possible()) body += section("frf", "Frequency responses", frf_html(analysis));
  if (with_hits) {
    body +=
        section("hits", "Hits",
                hits_table(analysis, analysis.hits()).shown.html() + picture("force", "Force of every hit over time.") +
                    picture("decay", "Decay of the responses in decibels over time."));
  }
  if (analysis.possible()) {
    body +=
        section("movement", "How the barrel moves", picture("movement", "Cross-section of the barrel in each mode."));
    body += section("stabilisation", "Stabilisation",
                    picture("stabilisation", "Poles of every model order over frequency."));
  }
  body += section("provenance", "How this came about", provenance_html(analysis, provenance)) + "</main>\n";
  return HtmlPage{.title = name + " – percuss", .body = body, .data = analysis_pictures(analysis)}.text();
}

}  // namespace percuss
