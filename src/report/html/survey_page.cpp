#include "report/html/survey_page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/html/analysis_page.hpp"
#include "report/html/analysis_plot_data.hpp"
#include "report/html/fit_plot_data.hpp"
#include "report/html/html_page.hpp"
#include "report/html/method_section.hpp"
#include "report/html/shapes_section.hpp"
#include "report/json/json_document.hpp"
#include "report/text/analysis_summary.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/html_escape.hpp"
#include "report/text/survey_text.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

bool has_tube_shapes(const pipeline::Survey& survey) {
  return std::any_of(survey.tubes().begin(), survey.tubes().end(), [](const auto& tube) { return tube.has_value(); });
}

}  // namespace

std::string survey_page(const pipeline::Survey& survey, const Provenance& provenance) {
  const pipeline::Analysis& analysis = survey.analysis();
  const bool with_hits = analysis.given_frfs() == nullptr, possible = analysis.possible();
  const std::vector<identify::ModeClassification> classifications =
      possible ? survey.classifications() : std::vector<identify::ModeClassification>();
  std::set<PagePart> parts = with_hits ? parts_of_hits() : std::set<PagePart>();
  if (possible) parts.insert({PagePart::fit, PagePart::stabilisation});
  if (!classifications.empty()) parts.insert(PagePart::shapes);
  const PageWarnings warnings(survey.warnings(), analysis.hits(), parts);
  const std::string summary = summary_sentence(analysis, classifications, possible ? &survey.modes() : nullptr);
  std::string found = "<p class=\"verdict\">" + html_escape(summary) + "</p>\n" + warnings.caution(), shapes;
  std::string data = "[" + analysis_plot_data(analysis, classifications, {}, possible ? &survey.modes() : nullptr);
  if (!classifications.empty()) {
    found += survey_modes_table(survey).html() + quoted_modes_key(classifications);
    data += "," + shapes_plot_data(survey);
    shapes = shapes_section(survey, warnings.beside(PagePart::shapes));
  }
  std::string body =
      page_header(title_of(analysis.record().files), test_conditions(analysis, with_hits ? analysis.hits().size() : 0),
                  with_file_facts(provenance.title_block, analysis)) +
      "<main>\n" + page_section("modes", "Modes", found) + warnings.section() + shapes;
  if (possible) {
    data += "," + ascii_text(Json{{"fit", fit_plot_json(analysis, &survey)},
                                  {"indicator", indicator_plot_json(analysis, survey.indicator())}});
    body += indicator_section(analysis) + frf_section(summary) + fit_section(analysis, warnings) +
            stabilisation_section(warnings);
  }
  if (with_hits) body += hits_section(analysis, warnings);
  body += method_section(analysis, {.modes = possible, .shapes_decide = possible && has_tube_shapes(survey)});
  body += page_section("provenance", "Provenance", page_provenance(analysis.record().files, provenance)) + "</main>\n";
  return HtmlPage{.title = page_title(title_of(analysis.record().files), provenance.title_block),
                  .body = body,
                  .block = provenance.title_block,
                  .data = data + "]"}
      .text();
}

}  // namespace percuss::report
