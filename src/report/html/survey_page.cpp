#include "report/html/survey_page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/html/analysis_page.hpp"
#include "report/html/analysis_plot_data.hpp"
#include "report/html/html_page.hpp"
#include "report/html/trust_section.hpp"
#include "report/json/json_document.hpp"
#include "report/json/quantised_curve.hpp"
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

// Shades in five steps: 0 … 0.2 … 1.
std::string mac_html(const pipeline::Survey& survey) {
  constexpr double kSteps = 5;
  std::string out =
      "<table class=\"mac\">\n<caption>MAC: 1 where two modes have the same shape on these "
      "points</caption>\n<tr><td></td>";
  const auto& macs = survey.macs();
  for (std::size_t j = 0; j < macs.size(); ++j) out += fmt::format("<th>{}</th>", j);
  for (std::size_t i = 0; i < macs.size(); ++i) {
    out += fmt::format("</tr>\n<tr><th>{}</th>", i);
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
  const std::string summary = summary_sentence(analysis, classifications);
  std::string found = "<p class=\"verdict\">" + html_escape(summary) + "</p>\n", shapes;
  std::string data = "[" + analysis_plot_data(analysis, classifications, {.stabilisation = false});
  if (!classifications.empty()) {
    found += survey_modes_table(survey).html() + quoted_modes_key(classifications);
    data += "," + ascii_text(Json{{"shapes", shapes_plot_json(wireframe(survey))}});
    shapes = page_section("shapes", "Mode shapes",
                          page_plot("shapes", "Animated points of the structure in each mode.") + mac_html(survey));
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
