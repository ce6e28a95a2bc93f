#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/svg/line_chart.hpp"
#include "report/text/report_text.hpp"
#include "report/trampoline_report.hpp"

namespace percuss::report {

/// Bats beside the model: its COR at each bat's hoop frequency.
struct BatsBesideModel {
  std::vector<MeasuredBat> bats;
  std::vector<double> model_cor;

  double difference(std::size_t i) const { return bats[i].bbcor - model_cor[i]; }
};
BatsBesideModel bats_beside_model(const model::Trampoline& model, const std::vector<MeasuredBat>& bats);

/// "bats" of the document, their lines of the text, and their points in the chart.
nlohmann::ordered_json trampoline_bats_json(const BatsBesideModel& beside);
ReportText trampoline_bats_text(const BatsBesideModel& beside);
ChartCurve trampoline_bats_curve(const BatsBesideModel& beside);

}  // namespace percuss::report
