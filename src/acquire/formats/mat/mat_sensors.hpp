#pragma once
#include <vector>

#include "acquire/formats/mat/mat_output.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes the angles and positions of the sensors as `angle_deg` and `position_m`, NaN where unknown; a variable is
/// left out where all are unknown.
void write_mat_sensors(MatOutput& out, const std::vector<SignalInfo>& accel);

}  // namespace percuss::acquire
