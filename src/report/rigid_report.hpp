#pragma once
#include <vector>

#include "model/bat/rigid_collision.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/model-rigid/1: exit speed, swing speed and effective mass at z_m, and the best of the range they span.
CommandReport rigid_report(const model::RigidCollision& collision, const std::vector<double>& z_m);

}  // namespace percuss::report
