#pragma once
#include <vector>

#include "model/rigid.hpp"
#include "report/model_report.hpp"

namespace percuss {

/// percuss/model-rigid/1: exit speed, swing speed and effective mass at z_m, and the best of the range they span.
ModelReport rigid_report(const RigidCollision& collision, const std::vector<double>& z_m);

}  // namespace percuss
