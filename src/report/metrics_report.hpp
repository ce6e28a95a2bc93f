#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "core/io/csv_cell.hpp"
#include "metrics/protocol/bat_metrics.hpp"
#include "metrics/protocol/resolution.hpp"
#include "report/html/command_report.hpp"
#include "report/json/bat_label.hpp"

namespace percuss::report {

/// The bat's profile in the laboratory's units; empty where it was not measured.
struct BatProfileReadings {
  std::optional<double> length_in, weight_oz, cg_in, handle_diameter_in, ball_g;
  std::vector<double> diameters_in;  // barrel diameters, an inch apart, from 3 in off the tip
  metrics::ProtocolSteps steps;
};

/// JSON: percuss/metrics/1. Each metric with its uncertainty, its equation and its inputs; the profile as the protocol
/// records it, and the bat where it is named.
CommandReport metrics_report(const metrics::BatReadings& readings, const BatProfileReadings& profile,
                             const std::optional<BatLabel>& bat = {});

/// A bat of a table, with its readings.
struct NamedMetrics {
  BatLabel label;
  metrics::BatReadings readings;
  BatProfileReadings profile;
};

/// JSON: percuss/metrics/1 with a list of bats. Table: a row per bat, which a study reads.
CommandReport metrics_table_report(const std::vector<NamedMetrics>& bats,
                                   CsvFormulas formulas = CsvFormulas::neutralise);

/// A metric: its key, unit and title, its value in this unit, and the equation.
struct MetricLine {
  const char* key;
  const char* unit;
  const char* title;
  std::optional<metrics::UncertainValue> value;
  std::string equation;
};

/// Parts of a standard deviation below this, relative to the value, are rounding errors of terms that cancel.
inline constexpr double kRoundingOfParts = 1e-14;

/// The standard deviation, 0 where it is such a rounding error.
inline double std_without_rounding(const metrics::UncertainValue& value) {
  return value.std() > kRoundingOfParts * std::abs(value.value()) ? value.std() : 0;
}

/// All metrics in the order of the reports.
std::vector<MetricLine> metric_lines(const metrics::BatReadings& readings, const metrics::BatMetrics& metrics);

/// The members of a document of one bat, without schema and version. `lines` and `warnings` belong to `metrics`.
nlohmann::ordered_json metrics_json(const metrics::BatMetrics& metrics, const std::vector<MetricLine>& lines,
                                    const std::vector<metrics::Warning>& warnings, const BatProfileReadings& profile);

}  // namespace percuss::report
