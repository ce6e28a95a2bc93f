#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/html/command_report.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/numeric_csv.hpp"
#include "report/text/report_text.hpp"
#include "report/trampoline_report.hpp"

namespace percuss::report {

/// Bats beside the model: its rebound at each bat's hoop frequency.
struct BatsBesideModel {
  std::vector<MeasuredBat> bats;
  std::vector<model::Rebound> rebounds;

  double difference(std::size_t i) const { return bats[i].bbcor - rebounds[i].cor; }
};
BatsBesideModel bats_beside_model(const model::Trampoline& model, const std::vector<MeasuredBat>& bats);

/// "bats" of the document, their lines of the text, and their points in the chart.
nlohmann::ordered_json trampoline_bats_json(const BatsBesideModel& beside);
ReportText trampoline_bats_text(const BatsBesideModel& beside);
ChartCurve trampoline_bats_curve(const BatsBesideModel& beside);

/// Adds the columns bbcor, difference and bat to the table of the curve, and a row per bat after its rows. The row of a
/// bat has the values of the curve at its hoop frequency, which `at_bats` holds.
void add_bats_rows(const std::vector<NumericColumn>& at_bats, const BatsBesideModel& beside, CommandReport& report);

}  // namespace percuss::report
