#include "report/html/survey_page.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/html/analysis_page.hpp"
#include "report/html/analysis_plot_data.hpp"
#include "report/html/html_page.hpp"
#include "report/html/shapes_section.hpp"
#include "report/html/trust_section.hpp"
#include "report/json/json_document.hpp"
#include "report/json/quantised_curve.hpp"
#include "report/text/analysis_summary.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/html_escape.hpp"
#include "report/text/survey_text.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json indicator_plot_json(const pipeline::Survey& survey) {
  constexpr Eigen::Index kMaxValues = 3;
  constexpr double kLevelStep_dB = 0.01;
  const acquire::LineRange band = survey.band();
  Json json{{"first_hz", band.freq_Hz(0)}, {"df_hz", band.df_Hz()}, {"values", Json::array()}};
  for (Eigen::Index i = 0; i < std::min(kMaxValues, survey.indicator().cols()); ++i) {
    std::vector<double> level_dB;
    for (const double value : survey.indicator().col(i)) level_dB.push_back(20 * std::log10(std::max(value, 1e-300)));
    const QuantisedCurve numbers = quantised_curve(level_dB, kLevelStep_dB);
    json["values"].push_back({{"from", numbers.from}, {"step", numbers.step}, {"u16", numbers.u16}});
  }
  return json;
}

}  // namespace

std::string survey_page(const pipeline::Survey& survey, const Provenance& provenance) {
  const pipeline::Analysis& analysis = survey.analysis();
  const bool with_hits = analysis.given_frfs() == nullptr, possible = analysis.possible();
  const std::vector<identify::ModeClassification> classifications =
      possible ? survey.classifications() : std::vector<identify::ModeClassification>();
  const std::string summary = summary_sentence(analysis, classifications);
  std::string found = "<p class=\"verdict\">" + html_escape(summary) + "</p>\n", shapes;
  std::string data = "[" + analysis_plot_data(analysis, classifications, {.stabilisation = false});
  if (!classifications.empty()) {
    found += survey_modes_table(survey).html() + quoted_modes_key(classifications);
    data += "," + shapes_plot_data(survey);
    shapes = shapes_section(survey);
  }
  std::string body = page_header(title_of(analysis.record().files),
                                 test_conditions(analysis, with_hits ? analysis.hits().size() : 0)) +
                     "<main>\n" + page_section("modes", "Modes", found) +
                     trust_section(survey.warnings(), analysis.hits()) + shapes;
  if (possible) {
    data += "," + ascii_text(Json{{"indicator", indicator_plot_json(survey)}});
    body += page_section("indicator", "Mode indicator",
                         page_paragraph("Singular values of the FRFs: if the second peaks with the first, two modes "
                                        "share a frequency.") +
                             page_plot("indicator", "Singular values of the FRFs in decibels over frequency."));
    body += frf_section(summary);
  }
  if (with_hits) body += hits_section(analysis);
  body += page_section("provenance", "Method and provenance", page_provenance(analysis.record().files, provenance)) +
          "</main>\n";
  return HtmlPage{.title = title_of(analysis.record().files) + " – percuss", .body = body, .data = data + "]"}.text();
}

}  // namespace percuss::report
