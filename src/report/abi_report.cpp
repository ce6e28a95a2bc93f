#include "report/abi_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

const char* metric_of(const metrics::AbiLog& log) { return log.bbcor ? "bbcor" : "besr"; }

const char* action_of(const metrics::AbiRun& run) {
  switch (run.next) {
    case metrics::AbiStep::done:
      return "stop";
    case metrics::AbiStep::roll:
      return "roll";
    case metrics::AbiStep::first_performance:
    case metrics::AbiStep::performance:
      return "performance";
    default:
      return "compression";
  }
}

std::string compression_name(const metrics::AbiReduction& c) {
  return c.cycle == 0 ? "BC 0" : fmt::format("BC {},{}", c.cycle, c.roll);
}

std::string abi_json(const metrics::AbiLog& log, const metrics::AbiRun& run) {
  const bool roll = run.next == metrics::AbiStep::roll;
  Json json{{"schema", "percuss/abi/1"},
            {"version", version()},
            {"bat", log.bat},
            {"material", log.material.empty() ? Json() : Json(log.material)},
            {"length_in", or_null(log.length_in)},
            {"moi_oz_in2", or_null(log.moi_ozin2)},
            {"displacement_in", run.displacement_in},
            {"metric", metric_of(log)},
            {"limit", or_null(log.limit)},
            {"verdict", name_of(run.verdict)},
            {"why", run.why},
            {"next",
             {{"step", run.next == metrics::AbiStep::done ? Json() : Json(static_cast<int>(run.next))},
              {"action", action_of(run)},
              {"depth_in", roll ? Json(metrics::next_depth_in(run)) : Json()},
              {"message", metrics::next_step_text(run)}}},
            {"cycle", run.cycle},
            {"roll", run.roll},
            {"compressions", Json::array()},
            {"cycles", Json::array()},
            {"remarks", Json::array()}};
  for (const metrics::AbiReduction& c : run.compressions) {
    json["compressions"].push_back({{"step", static_cast<int>(c.step)},
                                    {"cycle", c.cycle},
                                    {"roll", c.roll},
                                    {"force_lbf", c.mean_lbf},
                                    {"reduction", or_null(c.reduction)}});
  }
  for (const metrics::AbiCycle& c : run.cycles) {
    json["cycles"].push_back({{"cycle", c.cycle},
                              {"value", c.value},
                              {"best", c.best},
                              {"hoop_hz", or_null(c.hoop_Hz)},
                              {"z_in", or_null(c.z_in)},
                              {"id", c.id}});
  }
  for (const metrics::ProtocolFinding& r : run.remarks)
    json["remarks"].push_back({{"code", r.code}, {"message", r.message}});
  return indented_text(json) + "\n";
}

ReportText abi_text(const metrics::AbiLog& log, const metrics::AbiRun& run) {
  ReportText out;
  out.say(fmt::format("{}: {}", log.bat, metrics::next_step_text(run)));
  if (run.verdict == metrics::AbiVerdict::fail && run.next != metrics::AbiStep::done)
    out += "  the bat has failed (" + run.why + "); the test continues at the sponsor's request\n";
  for (const metrics::ProtocolFinding& remark : run.remarks) out.say("note: " + remark.message);
  if (!run.compressions.empty()) {
    TextTable table({{"compression"}, {"force", TextTable::Align::right}, {"reduction", TextTable::Align::right}});
    for (const metrics::AbiReduction& c : run.compressions) {
      table.add({compression_name(c), fmt::format("{:.1f} lbf", c.mean_lbf),
                 c.reduction ? fmt::format("{:.2f} %", 100 * *c.reduction) : ""});
    }
    out += "\n";
    out += table;
    out += fmt::format("compressed by {:g} in\n", run.displacement_in);
  }
  if (!run.cycles.empty()) {
    TextTable table({{"test"},
                     {metric_of(log), TextTable::Align::right},
                     {"below best", TextTable::Align::right},
                     {"hoop", TextTable::Align::right}});
    for (const metrics::AbiCycle& c : run.cycles) {
      table.add({fmt::format("{}", c.cycle), fmt::format("{:.4f}", c.value), fmt::format("{:.4f}", c.best - c.value),
                 c.hoop_Hz ? fmt::format("{:.0f} Hz", *c.hoop_Hz) : ""});
    }
    out += "\n";
    out += table;
  }
  return out;
}

std::string abi_csv(const metrics::AbiRun& run) {
  std::string out = "kind,cycle,roll,force_lbf,reduction,value,hoop_hz\n";
  const auto cell = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; };
  for (const metrics::AbiReduction& c : run.compressions)
    out += fmt::format("compression,{},{},{},{},,\n", c.cycle, c.roll, c.mean_lbf, cell(c.reduction));
  for (const metrics::AbiCycle& c : run.cycles)
    out += fmt::format("performance,{},,,,{},{}\n", c.cycle, c.value, cell(c.hoop_Hz));
  return out;
}

LineChart abi_chart(const metrics::AbiLog& log, const metrics::AbiRun& run) {
  ChartCurve tests{.name = "test", .marks = true};
  for (const metrics::AbiCycle& c : run.cycles) {
    tests.x.push_back(c.cycle);
    tests.y.push_back(c.value);
  }
  LineChart chart{.title = fmt::format("{}: {} over the break-in", log.bat, metric_of(log)),
                  .x = {.label = "performance test"},
                  .y = {.label = metric_of(log)},
                  .curves = {tests}};
  if (log.limit && !tests.x.empty())
    chart.curves.push_back({.name = "limit", .x = {tests.x.front(), tests.x.back()}, .y = {*log.limit, *log.limit}});
  return chart;
}

// The hoop frequency over the tests; none without a measured one.
std::optional<LineChart> hoop_chart(const metrics::AbiLog& log, const metrics::AbiRun& run) {
  ChartCurve hoop{.name = "first hoop mode", .marks = true};
  for (const metrics::AbiCycle& c : run.cycles) {
    if (!c.hoop_Hz) continue;
    hoop.x.push_back(c.cycle);
    hoop.y.push_back(*c.hoop_Hz);
  }
  if (hoop.x.empty()) return std::nullopt;
  return LineChart{.title = fmt::format("{}: hoop frequency over the break-in", log.bat),
                   .x = {.label = "performance test"},
                   .y = {.label = "hoop frequency before the test, Hz"},
                   .curves = {hoop}};
}

}  // namespace

CommandReport abi_report(const metrics::AbiLog& log, const metrics::AbiRun& run) {
  CommandReport report;
  report.json = abi_json(log, run);
  report.text = abi_text(log, run);
  report.table = abi_csv(run);
  report.charts = {abi_chart(log, run)};
  if (auto hoop = hoop_chart(log, run)) report.charts.push_back(std::move(*hoop));
  return report;
}

}  // namespace percuss::report
