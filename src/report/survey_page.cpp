#include "report/survey_page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "report/analysis_page.hpp"
#include "report/analysis_pictures.hpp"
#include "report/analysis_tables.hpp"
#include "report/analysis_verdict.hpp"
#include "report/html_page.hpp"
#include "report/html_text.hpp"
#include "report/survey_drawing.hpp"
#include "report/survey_text.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

// Six digits are more than a picture shows.
double shown(double value) { return std::isfinite(value) ? std::stod(fmt::format("{:.6g}", value)) : 0; }

// The points that can be drawn, by number, in the order of the picture.
std::map<int, std::size_t> drawn_points(const Survey& survey) {
  std::map<int, std::size_t> out;
  for (const ShapePlace& place : survey.shapes().front().places) {
    if (drawn_at(survey, place.point)) out.emplace(static_cast<int>(place.point), out.size());
  }
  return out;
}

Json movement(const Survey& survey, const ModeShape& shape, const std::map<int, std::size_t>& points) {
  std::vector<std::array<Complex, 3>> moves(points.size());
  const bool sensors = survey.options().roving == Roving::sensor;
  for (const ShapePlace& place : shape.places) {
    const auto at = points.find(static_cast<int>(place.point));
    if (at == points.end()) continue;
    const auto normal = drawn_normal(&survey, survey.analysis(), place.point, place.channel, sensors);
    for (std::size_t i = 0; i < 3; ++i) moves[at->second][i] += place.value * normal[i];
  }
  Json out = Json::array();
  for (const auto& move : moves) {
    for (const Complex& component : move) {
      out.push_back(shown(component.real()));
      out.push_back(shown(component.imag()));
    }
  }
  return out;
}

Json shapes_picture(const Survey& survey) {
  const auto points = drawn_points(survey);
  std::set<int> numbers;
  Json places = Json::array(), lines = Json::array(), modes = Json::array();
  for (const auto& [number, index] : points) numbers.insert(number);
  for (const auto& [number, index] : points) {
    const auto at = drawn_at(survey, static_cast<std::size_t>(number));
    places.push_back({shown((*at)[0]), shown((*at)[1]), shown((*at)[2])});
  }
  for (const auto& [from, to] : drawn_lines(survey, numbers)) {
    if (points.contains(from) && points.contains(to)) lines.push_back({points.at(from), points.at(to)});
  }
  for (std::size_t m = 0; m < survey.shapes().size(); ++m) {
    modes.push_back({{"name", mode_name(survey.verdicts()[m], m)},
                     {"hz", survey.analysis().modes()[m].pole.freq_Hz},
                     {"moves", movement(survey, survey.shapes()[m], points)}});
  }
  return {{"points", std::move(places)}, {"lines", std::move(lines)}, {"modes", std::move(modes)}};
}

// Shades in five steps: 0 … 0.2 … 1.
std::string mac_html(const Survey& survey) {
  constexpr double kSteps = 5;
  std::string out =
      "<table class=\"mac\">\n<caption>MAC: 1 where two modes have the same shape on these "
      "points</caption>\n<tr><td></td>";
  const auto& macs = survey.macs();
  for (std::size_t j = 0; j < macs.size(); ++j) out += fmt::format("<th>{}</th>", j);
  for (std::size_t i = 0; i < macs.size(); ++i) {
    out += fmt::format("</tr>\n<tr><th>{}</th>", i);
    for (const Mac& mac : macs[i]) {
      const int shade = static_cast<int>(std::min(kSteps - 1, std::floor(mac.value * kSteps)));
      out += fmt::format("<td class=\"right shade{}\">{:.2f}</td>", std::max(0, shade), mac.value);
    }
  }
  return out + "</tr>\n</table>\n";
}

}  // namespace

std::string survey_page(const Survey& survey, const Provenance& provenance) {
  const Analysis& analysis = survey.analysis();
  const bool with_hits = analysis.given_frfs() == nullptr, possible = analysis.possible();
  const std::vector<Verdict> verdicts = possible ? survey.verdicts() : std::vector<Verdict>();
  const std::string verdict = verdict_sentence(analysis, verdicts);
  std::string found = "<p class=\"verdict\">" + html_text(verdict) + "</p>\n", shapes;
  std::string data = "[" + analysis_pictures(analysis, verdicts, false);
  if (!verdicts.empty()) {
    found += survey_modes_table(survey).html();
    data += "," + Json{{"shapes", shapes_picture(survey)}}.dump(-1, ' ', true, Json::error_handler_t::replace);
    shapes = page_section("shapes", "Mode shapes",
                          page_picture("shapes", "The structure's points moving in each mode.") + mac_html(survey));
  }
  std::string body =
      page_header(title_of(analysis.record().files), conditions_of(analysis, with_hits ? analysis.hits().size() : 0)) +
      "<main>\n" + page_section("modes", "Modes", found + page_warnings(survey.warnings())) + shapes;
  if (possible) body += frf_section(verdict);
  if (with_hits) body += hits_section(analysis);
  body += page_section("provenance", "How this came about", page_provenance(analysis.record().files, provenance)) +
          "</main>\n";
  return HtmlPage{.title = title_of(analysis.record().files) + " – percuss", .body = body, .data = data + "]"}.text();
}

}  // namespace percuss
