#pragma once
#include <vector>

#include "metrics/protocol/bat_metrics.hpp"

namespace percuss::metrics {

/// Warnings `implausible_value`: readings and results outside the range that bats, balls and shots have. Each names the
/// value, the usual range, the reason and the reading to check.
std::vector<Warning> implausible_values(const BatReadings& readings, const BatMetrics& metrics);

}  // namespace percuss::metrics
