#pragma once
#include <optional>
#include <vector>

#include "metrics/protocol/bat_metrics.hpp"
#include "metrics/protocol/resolution.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// The bat's profile as the laboratory reads it, in its units; what was not read is absent.
struct BatProfileReadings {
  std::optional<double> length_in, weight_oz, cg_in, handle_in, ball_g;
  std::vector<double> rings_in;  // barrel diameters from the ring 3 in from the tip on, an inch apart
  metrics::ProtocolSteps steps;
};

/// percuss/metrics/1: every metric with its uncertainty, the equation that gave it and what it came from; the profile
/// as the protocol records it.
CommandReport metrics_report(const metrics::BatReadings& readings, const BatProfileReadings& profile);

}  // namespace percuss::report
