#include "report/trampoline_bats_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxRows = 40;  // of the text; the document has all

}  // namespace

BatsBesideModel bats_beside_model(const model::Trampoline& model, const std::vector<MeasuredBat>& bats) {
  BatsBesideModel out{.bats = bats, .rebounds = {}};
  std::vector<double> hoop_Hz;
  for (const MeasuredBat& bat : bats) hoop_Hz.push_back(bat.hoop_Hz);
  out.rebounds = model::hoop_sweep(model, hoop_Hz);
  return out;
}

nlohmann::ordered_json trampoline_bats_json(const BatsBesideModel& beside) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < beside.bats.size(); ++i) {
    out.push_back({{"id", beside.bats[i].id},
                   {"hoop_hz", beside.bats[i].hoop_Hz},
                   {"bbcor", beside.bats[i].bbcor},
                   {"cor", beside.rebounds[i].cor},
                   {"difference", beside.difference(i)}});
  }
  return out;
}

ReportText trampoline_bats_text(const BatsBesideModel& beside) {
  TextTable table({{"bat"},
                   {"hoop frequency", TextTable::Align::right},
                   {"BBCOR", TextTable::Align::right},
                   {"model", TextTable::Align::right},
                   {"difference", TextTable::Align::right}});
  const std::size_t shown = std::min(beside.bats.size(), kMaxRows);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < beside.bats.size(); ++i) {
    sum += beside.difference(i);
    if (i >= shown) continue;
    table.add({beside.bats[i].id, fmt::format("{:.1f} Hz", beside.bats[i].hoop_Hz),
               fmt::format("{:.4f}", beside.bats[i].bbcor), fmt::format("{:.4f}", beside.rebounds[i].cor),
               fmt::format("{:+.4f}", beside.difference(i))});
  }
  const auto count = static_cast<double>(beside.bats.size());
  const double mean = sum / count;
  for (std::size_t i = 0; i < beside.bats.size(); ++i) squares += std::pow(beside.difference(i) - mean, 2);
  ReportText out;
  out += "\n";
  out += table;
  if (shown < beside.bats.size()) out += fmt::format("and {} more bats\n", beside.bats.size() - shown);
  out += fmt::format("BBCOR minus the model's COR: mean {:+.4f}", mean);
  if (beside.bats.size() > 1) out += fmt::format(", standard deviation {:.4f}", std::sqrt(squares / (count - 1)));
  out += "\n";
  return out;
}

ChartCurve trampoline_bats_curve(const BatsBesideModel& beside) {
  ChartCurve out{.name = "BBCOR of bats", .line = false, .mark = ChartMark::open_diamond, .style = 2};
  for (const MeasuredBat& bat : beside.bats) {
    out.x.push_back(bat.hoop_Hz);
    out.y.push_back(bat.bbcor);
    out.labels.push_back(beside.bats.size() <= 12 ? bat.id : "");
  }
  return out;
}

void add_bats_rows(const std::vector<NumericColumn>& at_bats, const BatsBesideModel& beside, CommandReport& report) {
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  const std::size_t points = report.columns.front().values.size(), bats = beside.bats.size();
  for (NumericColumn& column : report.columns) {
    const auto same =
        std::find_if(at_bats.begin(), at_bats.end(), [&](const auto& c) { return c.name == column.name; });
    for (std::size_t i = 0; i < bats; ++i) column.values.push_back(same == at_bats.end() ? kAbsent : same->values[i]);
  }
  NumericColumn bbcor{.name = "bbcor", .values = std::vector<double>(points, kAbsent)}, difference = bbcor;
  difference.name = "difference";
  WordColumn ids{.name = "bat", .values = std::vector<std::string>(points)};
  for (std::size_t i = 0; i < bats; ++i) {
    bbcor.values.push_back(beside.bats[i].bbcor);
    difference.values.push_back(beside.difference(i));
    ids.values.push_back(beside.bats[i].id);
  }
  report.columns.push_back(std::move(bbcor));
  report.columns.push_back(std::move(difference));
  report.words.push_back(std::move(ids));
}

}  // namespace percuss::report
