#pragma once
#include <optional>
#include <vector>

#include "metrics/protocol/bat_metrics.hpp"
#include "metrics/protocol/resolution.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// The bat's profile in the laboratory's units; empty where it was not measured.
struct BatProfileReadings {
  std::optional<double> length_in, weight_oz, cg_in, handle_in, ball_g;
  std::vector<double> rings_in;  // barrel diameters, an inch apart, from 3 in off the tip
  metrics::ProtocolSteps steps;
};

/// JSON: percuss/metrics/1. Each metric with its uncertainty, its equation and its inputs; the profile as the protocol
/// records it.
CommandReport metrics_report(const metrics::BatReadings& readings, const BatProfileReadings& profile);

}  // namespace percuss::report
