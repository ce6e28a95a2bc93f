#include "report/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/csv/study_csv.hpp"
#include "report/json/json_document.hpp"
#include "report/svg/study_charts.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

const char* family_name(metrics::StudyFamily family) {
  return family == metrics::StudyFamily::wood ? "wood" : "nonwood";
}

Json correlation_json(const metrics::Correlation& c) { return {{"value", c.value}, {"low", c.low}, {"high", c.high}}; }

Json association_json(const std::optional<metrics::Association>& a) {
  if (!a) return {};
  return {{"bats", a->points},
          {"lengths", a->classes},
          {"pearson", correlation_json(a->pearson)},
          {"spearman", correlation_json(a->spearman)},
          {"p", a->p}};
}

Json trend_json(const std::optional<metrics::TrendLine>& t) {
  if (!t) return {};
  const auto end = [](double slope) { return std::isfinite(slope) ? Json(slope) : Json(); };
  return {
      {"slope", t->slope}, {"at_zero", t->at}, {"slope_low", end(t->slope_low)}, {"slope_high", end(t->slope_high)}};
}

Json ids_json(const metrics::Study& study, const std::vector<std::size_t>& bats) {
  Json out = Json::array();
  for (const std::size_t b : bats) out.push_back(study.bats[b].id);
  return out;
}

std::vector<std::size_t> bats_without_family(const metrics::Study& study) {
  std::vector<std::size_t> bats;
  for (std::size_t b = 0; b < study.bats.size(); ++b) {
    if (study.bats[b].without_family) bats.push_back(b);
  }
  return bats;
}

Json class_json(const metrics::Study& study, const metrics::StudyClass& one) {
  return {{"length_in", one.length_class == 0 ? Json() : Json(one.length_class)},
          {"bats", one.bats.size()},
          {"association", association_json(one.association)},
          {"trend", trend_json(one.trend)},
          {"outliers", ids_json(study, one.outliers)}};
}

Json figure_json(const metrics::Study& study, const metrics::StudyFigure& figure) {
  Json json{{"name", figure.name},
            {"title", figure.title},
            {"source", figure.source.empty() ? Json() : Json(figure.source)},
            {"x", metrics::column_of(figure.x)},
            {"y", metrics::column_of(figure.y)},
            {"family", family_name(figure.family)},
            {"length_in", figure.length_class == 0 ? Json() : Json(figure.length_class)},
            {"classes", Json::array()}};
  for (const metrics::StudyClass& one : figure.classes) json["classes"].push_back(class_json(study, one));
  return json;
}

Json statement_json(const metrics::StudyStatement& s) {
  return {{"text", s.text},
          {"x", metrics::column_of(s.x)},
          {"y", metrics::column_of(s.y)},
          {"family", family_name(s.family)},
          {"sign", s.sign},
          {"verdict", name_of(s.verdict)},
          {"adjusted_p", s.association ? Json(s.adjusted_p) : Json()},
          {"association", association_json(s.association)}};
}

Json groups_json(const metrics::Study& study) {
  Json out = Json::array();
  for (const metrics::StudyGroup& g : study.groups) {
    Json group{{"material", name_of(g.material)},
               {"kind", g.kind},
               {"program", g.program},
               {"states", g.states},
               {"bats", g.bats},
               {"quantities", Json::array()}};
    for (const metrics::QuantitySummary& q : g.quantities) {
      group["quantities"].push_back({{"quantity", metrics::column_of(q.quantity)},
                                     {"states", q.states},
                                     {"mean", q.mean},
                                     {"std", q.states > 1 ? Json(q.std) : Json()},
                                     {"low", q.low},
                                     {"high", q.high}});
    }
    out.push_back(std::move(group));
  }
  return out;
}

std::string interval(const metrics::Correlation& c) {
  return fmt::format("{:+.2f} [{:+.2f}, {:+.2f}]", c.value, c.low, c.high);
}

std::string verdict_words(const metrics::StudyStatement& s) {
  if (!s.association) return "too few bats";
  if (s.sign == 0 && s.verdict == metrics::StatementVerdict::not_supported) return "no relation found";
  return name_of(s.verdict);
}

void add_outliers(const metrics::Study& study, ReportText& out) {
  bool first = true;
  for (const metrics::StudyFigure& figure : study.figures) {
    if (figure.length_class != 0) continue;
    std::string names;
    for (const metrics::StudyClass& one : figure.classes) {
      for (const std::size_t b : one.outliers) names += (names.empty() ? "" : ", ") + study.bats[b].id;
    }
    if (names.empty()) continue;
    if (first) out += "\n";
    first = false;
    out.say(fmt::format("outliers, {}: {}", figure.title, names));
  }
}

std::string study_json(const metrics::Study& study) {
  Json json{{"schema", "percuss/study/1"}, {"version", version()},     {"bats", study.bats.size()},
            {"statements", Json::array()}, {"figures", Json::array()}, {"trails", Json::array()}};
  json["programs"] = Json::array();
  for (const metrics::StudyProgram& p : study.programs)
    json["programs"].push_back({{"program", p.name}, {"bats", p.bats}, {"counted", p.counted}});
  json["groups"] = groups_json(study);
  json["bats_without_family"] = ids_json(study, bats_without_family(study));
  for (const metrics::StudyStatement& s : study.statements) json["statements"].push_back(statement_json(s));
  for (const metrics::StudyFigure& f : study.figures) json["figures"].push_back(figure_json(study, f));
  for (const metrics::StudyHistory& t : study.histories) {
    json["trails"].push_back({{"bat", t.bat},
                              {"states", ids_json(study, t.states)},
                              {"besr", association_json(t.besr)},
                              {"bbs_mph", association_json(t.bbs)},
                              {"bbcor", association_json(t.bbcor)}});
  }
  return indented_text(json) + "\n";
}

// BESR and BBCOR with three decimals, drop and speeds with one, frequencies and MOI with none.
std::string quantity_text(metrics::StudyQuantity quantity, double value) {
  using enum metrics::StudyQuantity;
  if (quantity == besr || quantity == bbcor) return fmt::format("{:.3f}", value);
  return quantity == drop || quantity == bbs ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

void add_groups(const metrics::Study& study, ReportText& out) {
  TextTable table({{"group"},
                   {"quantity"},
                   {"states", TextTable::Align::right},
                   {"mean", TextTable::Align::right},
                   {"std", TextTable::Align::right},
                   {"range", TextTable::Align::right}});
  for (const metrics::StudyGroup& g : study.groups) {
    std::string name = name_of(g.material);
    if (g.kind != "all") name += ", " + g.kind + (study.programs.size() > 1 ? ", " + g.program : "");
    for (const metrics::QuantitySummary& q : g.quantities) {
      const auto text = [&](double value) { return quantity_text(q.quantity, value); };
      table.add({name, metrics::axis_of(q.quantity), fmt::format("{}", q.states), text(q.mean),
                 q.states > 1 ? text(q.std) : "", text(q.low) + " to " + text(q.high)});
    }
  }
  out += "\n";
  out += table;
}

void add_programs(const metrics::Study& study, ReportText& out) {
  for (const metrics::StudyProgram& p : study.programs) {
    if (p.counted || p.bats == 0) continue;
    out.say({fmt::format("{} bats of the program {} are drawn, but not part of statements, trends and correlations",
                         p.bats, p.name),
             {"program"}});
  }
}

void add_without_family(const metrics::Study& study, ReportText& out) {
  const std::size_t bats = bats_without_family(study).size();
  if (bats == 0) return;
  out.warn(
      fmt::format("the modes of {} of {} bats have no family, as with one accelerometer, and none of their "
                  "frequencies takes part; measure with two accelerometers 90° apart around the barrel, or state "
                  "bending1_hz, bending2_hz, hoop1_hz or hoop2_hz in a table",
                  bats, study.bats.size()));
}

ReportText study_text(const metrics::Study& study) {
  ReportText out = fmt::format(
      "{} bats, {} figures; ρ within lengths with its 95 % interval, p adjusted for all "
      "statements\n\n",
      study.bats.size(), study.figures.size());
  TextTable table(
      {{"statement"}, {"verdict"}, {"bats", TextTable::Align::right}, {"p"}, {"ρ (Spearman)"}, {"r (Pearson)"}});
  for (const metrics::StudyStatement& s : study.statements) {
    const auto& a = s.association;
    table.add({s.text, verdict_words(s), a ? fmt::format("{}", a->points) : "",
               a ? fmt::format("{:.2g}", s.adjusted_p) : "", a ? interval(a->spearman) : "",
               a ? interval(a->pearson) : ""});
  }
  out += table;
  for (const metrics::StudyHistory& t : study.histories) {
    if (t.besr) {
      out += fmt::format("\n{}, {} states: BESR over the hoop frequency ρ = {}", t.bat, t.states.size(),
                         interval(t.besr->spearman));
    }
  }
  if (!study.histories.empty()) out += "\n";
  add_programs(study, out);
  add_outliers(study, out);
  add_groups(study, out);
  add_without_family(study, out);
  return out;
}

}  // namespace

CommandReport study_report(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve,
                           CsvFormulas formulas) {
  CommandReport report;
  report.json = study_json(study);
  report.text = study_text(study);
  report.table = study_csv(study, formulas);
  report.charts = study_charts(study, curve);
  return report;
}

}  // namespace percuss::report
