#include "report/analysis_page.hpp"

#include <fmt/format.h>

#include "report/analysis_pictures.hpp"
#include "report/analysis_tables.hpp"
#include "report/analysis_verdict.hpp"
#include "report/html_page.hpp"
#include "report/html_text.hpp"

namespace percuss {

std::string frf_section(const std::string& verdict) {
  return page_section(
      "frf", "Frequency responses",
      page_paragraph("Drag to enlarge a stretch of frequencies in all three pictures, double-click to see all again.") +
          page_picture("magnitude", "Magnitude of the frequency responses in decibels over frequency. " + verdict) +
          page_picture("phase", "Phase of the frequency responses over frequency.") +
          page_picture("coherence", "Coherence over frequency, 0 to 1."));
}

std::string hits_section(const Analysis& analysis) {
  const HitsTable table = hits_table(analysis, analysis.hits());
  const std::string more =
      table.left_out > 0 ? page_paragraph(fmt::format("… and {} more hits in order.", table.left_out)) : "";
  return page_section("hits", "Hits",
                      table.shown.html() + more + page_picture("force", "Force of the first hits over time.") +
                          page_picture("decay", "Decay of the responses in decibels over time."));
}

std::string analysis_page(const Analysis& analysis, const Provenance& provenance) {
  const bool with_hits = analysis.given_frfs() == nullptr, possible = analysis.possible();
  const std::vector<Verdict> verdicts = possible ? analysis.verdicts() : std::vector<Verdict>();
  const std::string verdict = verdict_sentence(analysis, verdicts);
  std::string found = "<p class=\"verdict\">" + html_text(verdict) + "</p>\n";
  if (!verdicts.empty()) found += modes_table(analysis, true).html();
  std::string body =
      page_header(title_of(analysis.record().files), conditions_of(analysis, with_hits ? analysis.hits().size() : 0)) +
      "<main>\n" + page_section("modes", "Modes", found + page_warnings(analysis.warnings()));
  if (possible) body += frf_section(verdict);
  if (with_hits) body += hits_section(analysis);
  if (possible) {
    body += page_section("movement", "How the barrel moves",
                         page_picture("movement", "Cross-section of the barrel in each mode."));
    body += page_section("stabilisation", "Stabilisation",
                         page_picture("stabilisation", "Poles of every model order over frequency."));
  }
  body += page_section("provenance", "How this came about", page_provenance(analysis.record().files, provenance)) +
          "</main>\n";
  return HtmlPage{.title = title_of(analysis.record().files) + " – percuss",
                  .body = body,
                  .data = "[" + analysis_pictures(analysis, verdicts, true) + "]"}
      .text();
}

}  // namespace percuss
