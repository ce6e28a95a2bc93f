#pragma once
#include <vector>

#include "model/bat/rigid_collision.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/model-rigid/1. Exit speed, swing speed and effective mass at z_m, and the best impact of that range.
CommandReport rigid_report(const model::RigidCollision& collision, const std::vector<double>& z_m);

}  // namespace percuss::report
