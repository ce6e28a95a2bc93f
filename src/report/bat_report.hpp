#pragma once
#include <optional>
#include <vector>

#include "model/bat/bat_collision.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// Where and when percuss model bat is to show the bat's deflection.
struct BatWaveRequest {
  double z_m = 0;              // of the impact
  std::vector<double> time_s;  // from the touch on, ascending
};

/// percuss/model-bat/1: modes, nodes and inertia of a bat, and the exit speed of a ball over the place of impact z_m
/// (from the knob, ascending), for the bat that bends and for the rigid one. All of bat's modes take part. `profile` is
/// the bat's. With `wave` the table shows the deflection along the bat instead, and a chart as well.
CommandReport bat_report(const model::BatModes& bat, const model::BatProfile& profile,
                         const model::BatCollision& collision, const std::vector<double>& z_m,
                         const std::optional<BatWaveRequest>& wave = {});

}  // namespace percuss::report
