#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::metrics {

/// The readings of a bat and an impact in the laboratory's units. cg and z are from the barrel's tip.
struct LabReadings {
  std::optional<double> length_in, weight_oz, cg_in, moi_ozin2, ball_g, z_in, in_mph, out_mph, besr, bbcor, swing_mph;
  std::optional<double> handle_diameter_in;
  std::vector<double> diameters_in, periods_s, crossings_s;
  bool operator==(const LabReadings&) const = default;
};

/// A row of a table of readings.
struct ReadingsRow {
  std::string place;  // for messages
  std::string id;
  std::map<std::string, std::string> properties;  // texts and frequencies, passed on to a study
  LabReadings readings;
};

/// Reads a table of bats (docs/schema/metrics-table.schema.json, or the same as CSV): "id", the readings under the
/// names of the options of percuss metrics, and the texts and frequencies of a study's table. A cell without a value
/// takes the value of `common`, unless the row holds an alternative: moment of inertia, period or gate times; BESR,
/// BBCOR or rebound speed.
/// errors  InputError with the line: another document, an unknown column, an impossible value, a row without an id, one
/// id in two rows, more than 2000 rows.
std::vector<ReadingsRow> parse_readings_table(std::string_view text, const std::string& where,
                                              const LabReadings& common = {});

/// The columns of texts and frequencies that a row passes on.
const std::vector<std::string>& copied_columns();

/// An example table.
std::string readings_table_example();

}  // namespace percuss::metrics
