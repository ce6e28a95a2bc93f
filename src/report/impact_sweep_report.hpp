#pragma once
#include <string>
#include <vector>

#include "model/impact/impact.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/numeric_csv.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// A sweep: one parameter varies, the others have the values of the reported impact.
struct ImpactSweep {
  std::string parameter;  // "ei", "torsion", "rho_a", "at", "speed"
  std::vector<double> values;
  std::vector<model::ImpactResult> results;  // [values]
};

/// The value of `impact` that a sweep of `parameter` varies; nullptr for an unknown name.
double* swept_value(model::Impact& impact, const std::string& parameter);

/// The motion of beam and ball over time: time_s, deflection_m, force_n, ball_speed_mps and ball_m.
std::vector<NumericColumn> series_columns(const std::vector<model::ImpactMoment>& series);

std::vector<double> scaled(const std::vector<double>& values, double factor);

/// When the ball touches the beam again: "after 16.8 ms", or "none".
std::string recontact_text(const model::ImpactResult& result);

TextTable sweep_table(const ImpactSweep& sweep);

/// A row per impact; where the impacts hold their motion over time, a row per moment. The parameters of the impact
/// stand in every row. At least one sweep.
std::vector<NumericColumn> impact_sweep_columns(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps);

/// Restitution and, unless the beam flies off, largest deflection over the parameters; before them the deflection over
/// time, where the impacts hold it. At least one sweep.
std::vector<LineChart> impact_sweep_charts(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps,
                                           bool flies_off);

}  // namespace percuss::report
