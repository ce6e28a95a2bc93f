#include "report/impact_sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace percuss::report {
namespace {

struct SweptName {
  const char *key, *label;
};
constexpr std::array<SweptName, 5> kSwept{{{"ei", "EI, N·m²"},
                                           {"torsion", "torsion spring, N·m/rad"},
                                           {"rho_a", "mass per length, kg/m"},
                                           {"at", "impact from the spring's end, m"},
                                           {"speed", "ball speed, m/s"}}};

constexpr double kEmptyField = std::numeric_limits<double>::quiet_NaN();  // an empty field of the table

// A row per impact of all sweeps; parameters that a sweep does not vary keep their value.
std::vector<NumericColumn> sweep_columns(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps) {
  std::vector<NumericColumn> columns;
  columns.reserve(kSwept.size() + 8);
  for (const SweptName& name : kSwept) columns.push_back({name.key, {}});
  for (const char* name : {"cor", "contact_s", "peak_force_n", "peak_deflection_m", "peak_deflection_time_s",
                           "recontact_time_s", "final_cor", "contacts"})
    columns.push_back({name, {}});
  for (const ImpactSweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      model::Impact varied = impact;
      *swept_value(varied, sweep.parameter) = sweep.values[i];
      std::size_t c = 0;
      for (const SweptName& name : kSwept) columns[c++].values.push_back(*swept_value(varied, name.key));
      const model::ImpactResult& r = sweep.results[i];
      for (const double value :
           {r.cor, r.contact_s, r.peak_force_N, std::abs(r.peak_deflection_m), r.peak_deflection_time_s,
            r.recontact_s.value_or(kEmptyField), r.final_cor.value_or(kEmptyField), static_cast<double>(r.contacts)})
        columns[c++].values.push_back(value);
    }
  }
  return columns;
}

// The motion over time of each impact of the sweeps: a row per moment, with the parameters of its impact.
std::vector<NumericColumn> sweep_series_columns(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps) {
  std::vector<NumericColumn> columns;
  columns.reserve(kSwept.size());
  for (const SweptName& name : kSwept) columns.push_back({name.key, {}});
  std::vector<NumericColumn> motion = series_columns({});
  for (const ImpactSweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      model::Impact varied = impact;
      *swept_value(varied, sweep.parameter) = sweep.values[i];
      const std::vector<NumericColumn> one = series_columns(sweep.results[i].series);
      for (std::size_t c = 0; c < kSwept.size(); ++c)
        columns[c].values.resize(columns[c].values.size() + one[0].values.size(),
                                 *swept_value(varied, kSwept.at(c).key));
      for (std::size_t c = 0; c < one.size(); ++c)
        motion[c].values.insert(motion[c].values.end(), one[c].values.begin(), one[c].values.end());
    }
  }
  columns.insert(columns.end(), motion.begin(), motion.end());
  return columns;
}

// The deflection of the struck point over time, a curve per impact.
LineChart sweep_series_chart(const std::vector<ImpactSweep>& sweeps) {
  LineChart chart{.title = "Deflection of the struck point",
                  .x = {.label = "time after first touch, ms"},
                  .y = {.label = "deflection, mm"},
                  .curves = {}};
  for (const ImpactSweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      const std::vector<NumericColumn> motion = series_columns(sweep.results[i].series);
      chart.curves.push_back({fmt::format("{} {:.6g}", sweep.parameter, sweep.values[i]),
                              scaled(motion[0].values, 1000), scaled(motion[1].values, 1000)});
    }
  }
  return chart;
}

// Each sweep as a curve of the value `of` a result.
LineChart sweep_chart(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps, LineChart chart,
                      const std::function<double(const model::ImpactResult&)>& of) {
  model::Impact base = impact;
  for (const ImpactSweep& sweep : sweeps) {
    ChartCurve curve{.name = sweep.parameter, .x = sweep.values, .marks = true};
    if (sweeps.size() > 1) curve.x = scaled(sweep.values, 1 / *swept_value(base, sweep.parameter));
    curve.y.reserve(sweep.results.size());
    for (const model::ImpactResult& result : sweep.results) curve.y.push_back(of(result));
    chart.curves.push_back(std::move(curve));
  }
  chart.x.label = "parameter over its value without a sweep";
  for (const SweptName& name : kSwept) {
    if (sweeps.size() == 1 && sweeps.front().parameter == name.key) chart.x.label = name.label;
  }
  return chart;
}

bool has_series(const std::vector<ImpactSweep>& sweeps) { return !sweeps.front().results.front().series.empty(); }

// Restitution and, unless the beam flies off, deflection over the parameters.
std::vector<LineChart> sweep_charts(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps,
                                    bool flies_off) {
  std::vector<LineChart> charts{sweep_chart(impact, sweeps,
                                            {.title = "Ball on beam", .y = {.label = "coefficient of restitution"}},
                                            [](const model::ImpactResult& r) { return r.cor; })};
  if (!flies_off) {
    charts.push_back(sweep_chart(impact, sweeps,
                                 {.title = "Deflection of the struck point", .y = {.label = "largest deflection, mm"}},
                                 [](const model::ImpactResult& r) { return 1000 * std::abs(r.peak_deflection_m); }));
  }
  return charts;
}

}  // namespace

double* swept_value(model::Impact& impact, const std::string& parameter) {
  if (parameter == "ei") return &impact.beam.stiffness_Nm2;
  if (parameter == "torsion") return &impact.beam.torsion_Nmprad;
  if (parameter == "rho_a") return &impact.beam.mass_per_length_kgpm;
  if (parameter == "at") return &impact.at_m;
  return parameter == "speed" ? &impact.speed_mps : nullptr;
}

std::string recontact_text(const model::ImpactResult& r) {
  return r.recontact_s ? fmt::format("after {:.1f} ms", 1000 * *r.recontact_s) : "none";
}

std::vector<NumericColumn> series_columns(const std::vector<model::ImpactMoment>& series) {
  std::vector<NumericColumn> columns{
      {"time_s", {}}, {"deflection_m", {}}, {"force_n", {}}, {"ball_speed_mps", {}}, {"ball_m", {}}};
  for (NumericColumn& column : columns) column.values.reserve(series.size());
  for (const model::ImpactMoment& moment : series) {
    columns[0].values.push_back(moment.time_s);
    columns[1].values.push_back(moment.beam_m);
    columns[2].values.push_back(moment.force_N);
    columns[3].values.push_back(moment.ball_speed_mps);
    columns[4].values.push_back(moment.ball_m);
  }
  return columns;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> out = values;
  for (double& value : out) value *= factor;
  return out;
}

TextTable sweep_table(const ImpactSweep& sweep) {
  const bool several =
      std::any_of(sweep.results.begin(), sweep.results.end(), [](const auto& r) { return r.contacts > 1; });
  std::vector<TextTable::Column> heads{
      {sweep.parameter, TextTable::Align::right}, {"restitution", TextTable::Align::right},
      {"contact", TextTable::Align::right},       {"force", TextTable::Align::right},
      {"deflection", TextTable::Align::right},    {"second contact"}};
  if (several) heads.push_back({"restitution after the last contact", TextTable::Align::right});
  TextTable table(std::move(heads));
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const model::ImpactResult& r = sweep.results[i];
    std::vector<std::string> cells{
        fmt::format("{:.6g}", sweep.values[i]),
        fmt::format("{:.4f}", r.cor),
        fmt::format("{:.3f} ms", 1000 * r.contact_s),
        fmt::format("{:.4g} N", r.peak_force_N),
        r.flies_off ? "flies off" : fmt::format("{:.3f} mm", 1000 * std::abs(r.peak_deflection_m)),
        recontact_text(r)};
    if (several) cells.push_back(r.final_cor ? fmt::format("{:.4f}", *r.final_cor) : "not known");
    table.add(std::move(cells));
  }
  return table;
}

std::vector<NumericColumn> impact_sweep_columns(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps) {
  return has_series(sweeps) ? sweep_series_columns(impact, sweeps) : sweep_columns(impact, sweeps);
}

std::vector<LineChart> impact_sweep_charts(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps,
                                           bool flies_off) {
  std::vector<LineChart> charts = sweep_charts(impact, sweeps, flies_off);
  if (has_series(sweeps)) charts.insert(charts.begin(), sweep_series_chart(sweeps));
  return charts;
}

}  // namespace percuss::report
