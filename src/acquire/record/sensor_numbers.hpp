#pragma once
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// A place of every sensor (&SignalInfo::angle_rad or &SignalInfo::position_m) times `factor`, NaN where it is not
/// known. Empty where none is known.
std::vector<double> sensor_numbers(const std::vector<SignalInfo>& accel, std::optional<double> SignalInfo::*place,
                                   double factor = 1);

}  // namespace percuss::acquire
