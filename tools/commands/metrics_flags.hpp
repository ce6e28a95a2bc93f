#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command_options.hpp"
#include "cli/output.hpp"
#include "metrics/protocol/bat_metrics.hpp"
#include "metrics/protocol/readings_table.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::tools {

/// The options of percuss metrics as typed.
struct MetricsFlags : metrics::LabReadings {
  std::string table, bat_id;
  std::vector<std::string> bat;
  std::size_t crossings_per_period = 2;
  metrics::ProtocolSteps steps;
  double period_step_s = 0, moi_step_ozin2 = 0, z_step_in = 0, speed_step_mph = 0;
  double v0_mph = 60, pitch_mph = 70, nominal_mph = metrics::kNominalSpeed_mph, swing_length_in = 28,
         swing_moi_ozin2 = 15000;
  double gravity_inps2 = 386.4;
  metrics::BatReadings readings;
  bool rounded = false, example = false, keep_formulas = false;
  OutputFlags output;
};

/// Declare the readings, their resolutions, and the constants.
void add_metrics_readings(Command& command, MetricsFlags& f);
void add_metrics_resolutions(Command& command, MetricsFlags& f);
void add_metrics_constants(Command& command, MetricsFlags& f);

}  // namespace percuss::tools
