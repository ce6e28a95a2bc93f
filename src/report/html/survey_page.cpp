#include "report/html/survey_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/html/analysis_page.hpp"
#include "report/html/analysis_plot_data.hpp"
#include "report/html/fit_plot_data.hpp"
#include "report/html/html_page.hpp"
#include "report/html/method_section.hpp"
#include "report/json/json_document.hpp"
#include "report/svg/wireframe.hpp"
#include "report/text/analysis_summary.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/html_escape.hpp"
#include "report/text/survey_text.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Six digits exceed the resolution of a plot.
double shown(double value) { return std::isfinite(value) ? std::stod(fmt::format("{:.6g}", value)) : 0; }

Json shapes_plot_json(const Wireframe& frame) {
  Json places = Json::array(), lines = Json::array(), modes = Json::array();
  for (const auto& at : frame.points) places.push_back({shown(at[0]), shown(at[1]), shown(at[2])});
  for (const auto& [from, to] : frame.lines) lines.push_back({from, to});
  for (const WireframeMode& mode : frame.modes) {
    Json moves = Json::array();
    for (const auto& move : mode.moves) {
      for (const Complex& component : move) {
        moves.push_back(shown(component.real()));
        moves.push_back(shown(component.imag()));
      }
    }
    modes.push_back({{"name", mode.name}, {"hz", mode.freq_Hz}, {"moves", std::move(moves)}});
  }
  return {{"points", std::move(places)}, {"lines", std::move(lines)}, {"modes", std::move(modes)}};
}

bool has_tube_shapes(const pipeline::Survey& survey) {
  return std::any_of(survey.tubes().begin(), survey.tubes().end(), [](const auto& tube) { return tube.has_value(); });
}

// Shades in five steps: 0 … 0.2 … 1.
std::string mac_html(const pipeline::Survey& survey) {
  constexpr double kSteps = 5;
  std::string out =
      "<table class=\"mac\">\n<caption>MAC: 1 where two modes have the same shape on these "
      "points</caption>\n<tr><td></td>";
  const auto& macs = survey.macs();
  for (std::size_t j = 0; j < macs.size(); ++j) out += fmt::format("<th>{}</th>", j + 1);
  for (std::size_t i = 0; i < macs.size(); ++i) {
    out += fmt::format("</tr>\n<tr><th>{}</th>", i + 1);
    for (const identify::Mac& mac : macs[i]) {
      const int shade = static_cast<int>(std::min(kSteps - 1, std::floor(mac.value * kSteps)));
      out += fmt::format("<td class=\"right shade{}\">{:.2f}</td>", std::max(0, shade), mac.value);
    }
  }
  return out + "</tr>\n</table>\n";
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
  const std::string summary = summary_sentence(analysis, classifications);
  std::string found = "<p class=\"verdict\">" + html_escape(summary) + "</p>\n", shapes;
  std::string data = "[" + analysis_plot_data(analysis, classifications);
  if (!classifications.empty()) {
    found += survey_modes_table(survey).html() + quoted_modes_key(classifications);
    data += "," + ascii_text(Json{{"shapes", shapes_plot_json(wireframe(survey))}});
    shapes = page_section("shapes", "Mode shapes",
                          page_plot("shapes", "Animated points of the structure in each mode.") + mac_html(survey) +
                              warnings.beside(PagePart::shapes));
  }
  std::string body =
      page_header(title_of(analysis.record().files), test_conditions(analysis, with_hits ? analysis.hits().size() : 0),
                  with_file_facts(provenance.title_block, analysis)) +
      "<main>\n" + page_section("modes", "Modes", found) + warnings.section() + shapes;
  if (possible) {
    data += "," + ascii_text(Json{{"fit", fit_plot_json(analysis, &survey)},
                                  {"indicator", indicator_plot_json(analysis, survey.indicator())}});
    body += indicator_section() + frf_section(summary) + fit_section(warnings) + stabilisation_section(warnings);
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
