#include "report/certify_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

const char* state_name(metrics::SearchState state) {
  switch (state) {
    case metrics::SearchState::found:
      return "found";
    case metrics::SearchState::plateau:
      return "plateau";
    case metrics::SearchState::edge:
      return "edge";
    case metrics::SearchState::shoot:
      break;
  }
  return "shoot";
}

Json findings_json(const std::vector<metrics::ProtocolFinding>& findings) {
  Json out = Json::array();
  for (const metrics::ProtocolFinding& finding : findings)
    out.push_back({{"code", finding.code}, {"message", finding.message}});
  return out;
}

Json shots_json(const std::vector<metrics::SessionShot>& shots, const std::vector<metrics::JudgedShot>& judged) {
  Json out = Json::array();
  for (std::size_t i = 0; i < shots.size(); ++i) {
    out.push_back({{"index", i},
                   {"z_in", shots[i].z_in},
                   {"ball", shots[i].ball},
                   {"v_in_mph", judged[i].in_mph},
                   {"v_out_mph", judged[i].out_mph},
                   {"v_target_mph", judged[i].target_mph},
                   {"valid", judged[i].valid()},
                   {"counted", judged[i].counted},
                   {"reasons", findings_json(judged[i].reasons)}});
  }
  return out;
}

Json balls_json(const metrics::Certification& c) {
  Json out = Json::array();
  for (const auto& [id, ball] : c.balls) {
    out.push_back({{"ball", id},
                   {"mass_g", ball.ball_g},
                   {"impacts", ball.impacts},
                   {"ears", {ball.ears[1], ball.ears[2], ball.ears[3], ball.ears[4]}},
                   {"usable", ball.spent.empty()},
                   {"spent", ball.spent.empty() ? Json() : Json(ball.spent)}});
  }
  return out;
}

void add_metrics(Json& json, const metrics::LocationMetrics& m) {
  json["besr"] = m.besr;
  json["ncaa_besr"] = m.ncaa_besr;
  json["bbcor"] = or_null(m.bbcor);
  json["bbs_mph"] = or_null(m.bbs_mph);
  json["v_swing_mph"] = or_null(m.swing_mph);
}

// All metrics at the best location.
Json performance_json(const metrics::Certification& c) {
  if (!c.best_location) return {};
  Json out{{"z_in", c.locations[*c.best_location].z_in}};
  add_metrics(out, c.locations[*c.best_location].metrics);
  return out;
}

// The bat, with the properties that a study takes.
Json bat_json(const metrics::SessionBat& bat) {
  Json out{{"id", bat.id},
           {"length_in", bat.length_in},
           {"moi_oz_in2", or_null(bat.moi_ozin2)},
           {"weight_oz", or_null(bat.weight_oz)}};
  for (const auto& [key, text] :
       {std::pair{"material", &bat.material}, {"condition", &bat.condition}, {"program", &bat.program}}) {
    if (!text->empty()) out[key] = *text;
  }
  return out;
}

Json locations_json(const metrics::Certification& c) {
  Json out = Json::array();
  for (const metrics::TestedLocation& l : c.locations) {
    out.push_back({{"z_in", l.z_in},
                   {"valid_shots", l.valid},
                   {"complete", l.complete},
                   {"mean", l.mean},
                   {"std_error", l.std_error}});
    add_metrics(out.back(), l.metrics);
  }
  return out;
}

Json search_json(const metrics::SearchStep& search) {
  Json level = Json::array();
  for (const metrics::HalfInches at : search.plateau) level.push_back(0.5 * at);
  return {{"state", state_name(search.state)}, {"z_in", 0.5 * search.at}, {"within_margin_in", std::move(level)}};
}

Json next_json(const metrics::NextAction& next) {
  return {{"action", next.code},
          {"z_in", or_null(next.z_in)},
          {"v_target_mph", or_null(next.target_mph)},
          {"left", next.left},
          {"ball", next.ball.empty() ? Json() : Json(next.ball)},
          {"message", next.message}};
}

std::string joined_messages(const std::vector<metrics::ProtocolFinding>& findings) {
  std::string out;
  for (const metrics::ProtocolFinding& finding : findings) out += (out.empty() ? "" : "; ") + finding.message;
  return out;
}

std::string certify_json(const metrics::Session& s, const metrics::Certification& c) {
  const Json json{{"schema", "percuss/certify/1"},
                  {"version", version()},
                  {"bat", bat_json(s.bat)},
                  {"metric", name_of(s.metric)},
                  {"limit", or_null(s.limit)},
                  {"verdict", name_of(c.verdict)},
                  {"sweet_spot_in", or_null(c.sweet_spot_in)},
                  {"best", or_null(c.best)},
                  {"best_std", or_null(c.best_std)},
                  {"performance", performance_json(c)},
                  {"next", next_json(c.next)},
                  {"conditions", findings_json(c.conditions)},
                  {"remarks", findings_json(c.remarks)},
                  {"search", search_json(c.search)},
                  {"locations", locations_json(c)},
                  {"ball_lot",
                   {{"correction", or_null(c.correction)},
                    {"correction_std", or_null(c.correction_std)},
                    {"valid_hits", c.valid_lot_hits},
                    {"hits", shots_json(s.lot.hits, c.lot_hits)}}},
                  {"shots", shots_json(s.shots, c.shots)},
                  {"balls", balls_json(c)}};
  return indented_text(json) + "\n";
}

TextTable locations_table(const metrics::Session& s, const metrics::Certification& c) {
  const bool besr_column = s.metric != metrics::PerformanceMetric::besr, moi = s.bat.moi_ozin2.has_value();
  const bool bbcor_column = moi && s.metric != metrics::PerformanceMetric::bbcor;
  std::vector<TextTable::Column> columns{{"location", TextTable::Align::right},
                                         {"shots", TextTable::Align::right},
                                         {name_of(s.metric), TextTable::Align::right}};
  if (besr_column) columns.push_back({"BESR", TextTable::Align::right});
  if (bbcor_column) columns.push_back({"BBCOR", TextTable::Align::right});
  if (moi) columns.push_back({"batted-ball speed", TextTable::Align::right});
  columns.push_back({""});
  TextTable table(columns);
  for (const metrics::TestedLocation& l : c.locations) {
    std::vector<std::string> cells{fmt::format("{:.1f} in", l.z_in), fmt::format("{}", l.valid),
                                   value_with_std(l.mean, l.std_error)};
    if (besr_column) cells.push_back(fmt::format("{:.4f}", l.metrics.besr));
    if (bbcor_column) cells.push_back(fmt::format("{:.4f}", *l.metrics.bbcor));
    if (moi) cells.push_back(fmt::format("{:.2f} mph", *l.metrics.bbs_mph));
    cells.emplace_back(c.sweet_spot_in == l.z_in ? "sweet spot" : l.complete ? "" : "not complete");
    table.add(std::move(cells));
  }
  return table;
}

ReportText certify_text(const metrics::Session& s, const metrics::Certification& c) {
  ReportText out;
  out.say(fmt::format("{}: {}", s.bat.id, c.next.message));
  if (!c.next.ball.empty()) out += fmt::format("  ball: {}, or a new one\n", c.next.ball);
  for (const metrics::ProtocolFinding& f : c.conditions) out.say("condition: " + f.message);
  for (const metrics::ProtocolFinding& f : c.remarks) out.say("note: " + f.message);
  if (c.correction) out += fmt::format("ball lot: correction {:+.4f}\n", *c.correction);
  if (!c.locations.empty()) {
    out += "\n";
    out += locations_table(s, c);
  }
  for (std::size_t i = 0; i < c.shots.size(); ++i) {
    if (!c.shots[i].valid()) {
      out.say(fmt::format("shot {} does not count: {}", i + 1, joined_messages(c.shots[i].reasons)));
    }
  }
  for (const auto& [id, ball] : c.balls) {
    if (!ball.spent.empty()) out += fmt::format("remove ball {}: {}\n", id, ball.spent);
  }
  return out;
}

std::string certify_csv(const metrics::Session& s, const metrics::Certification& c) {
  std::string out = "index,z_in,v_in_mph,v_out_mph,v_target_mph,valid,counted,reasons\n";
  for (std::size_t i = 0; i < c.shots.size(); ++i) {
    const metrics::JudgedShot& shot = c.shots[i];
    std::string codes;
    for (const metrics::ProtocolFinding& reason : shot.reasons) codes += (codes.empty() ? "" : " ") + reason.code;
    out += fmt::format("{},{},{},{},{},{},{},{}\n", i, s.shots[i].z_in, shot.in_mph, shot.out_mph, shot.target_mph,
                       shot.valid() ? "yes" : "no", shot.counted ? "yes" : "no", codes);
  }
  return out;
}

LineChart certify_chart(const metrics::Session& s, const metrics::Certification& c) {
  ChartCurve means{.name = "mean of six", .marks = true};
  for (const metrics::TestedLocation& location : c.locations) {
    if (!location.complete) continue;
    means.x.push_back(location.z_in);
    means.y.push_back(location.mean);
  }
  LineChart chart{.title = fmt::format("{}: {} over the location", s.bat.id, name_of(s.metric)),
                  .x = {.label = "location from the barrel's tip, in"},
                  .y = {.label = name_of(s.metric)},
                  .curves = {means}};
  if (s.limit) chart.curves.push_back({.name = "limit", .x = {s.low_in, s.high_in}, .y = {*s.limit, *s.limit}});
  return chart;
}

// The bat, the ball lot and the terms of the test, at the head of the page.
std::vector<std::pair<std::string, std::string>> facts_of(const metrics::Session& s) {
  std::vector<std::pair<std::string, std::string>> facts{{"Bat", s.bat.id}};
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) facts.emplace_back(what, text);
  };
  std::string sizes = s.bat.length_in > 0 ? fmt::format("{:g} in", s.bat.length_in) : "";
  const auto size = [&](const std::optional<double>& value, const char* unit) {
    if (value) sizes += fmt::format("{}{:g} {}", sizes.empty() ? "" : ", ", *value, unit);
  };
  size(s.bat.weight_oz, "oz");
  size(s.bat.moi_ozin2, "oz in² about the pivot");
  add("Length, weight, MOI", sizes);
  add("Material", s.bat.material);
  add("Condition", s.bat.condition);
  add("Program", s.bat.program);
  add("Days in the laboratory", fmt::format("bat {:g}, balls {:g}", s.bat.days_in_lab, s.lot.days_in_lab));
  add("Ball lot", s.lot.id);
  add("Metric",
      std::string(name_of(s.metric)) + (s.limit ? fmt::format(", limit {:g}", *s.limit) : ", no limit stated"));
  return facts;
}

}  // namespace

CommandReport certify_report(const metrics::Session& session, const metrics::Certification& certification) {
  CommandReport report;
  report.json = certify_json(session, certification);
  report.text = certify_text(session, certification);
  report.table = certify_csv(session, certification);
  report.facts = facts_of(session);
  report.charts = {certify_chart(session, certification)};
  return report;
}

}  // namespace percuss::report
