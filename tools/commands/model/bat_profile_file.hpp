#pragma once
#include <string>

#include "model/bat/bat_profile.hpp"

namespace percuss::tools {

/// Reads a bat's profile: a line per slice, its far end from the knob and its diameter. `units` are those of the two
/// columns, as "cm:mm". errors  UsageError: units that are none of length; InputError with file and line: as
/// read_number_table; ends that do not ascend, diameters not above zero, larger than any bat, more than 1000 slices.
model::BatProfile read_bat_profile(const std::string& path, const std::string& units);

}  // namespace percuss::tools
