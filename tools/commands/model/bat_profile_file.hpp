#pragma once
#include <string>

#include "model/bat/bat_profile.hpp"

namespace percuss::tools {

/// Reads a bat's profile: a line per slice, with the position of its far end from the knob, and its diameter. `units`
/// of the two columns: "cm:mm". Throws UsageError for units that do not measure length. Throws InputError with file and
/// line as read_number_table, and for ends that do not ascend, diameters out of range and more than 1000 slices.
model::BatProfile read_bat_profile(const std::string& path, const std::string& units);

}  // namespace percuss::tools
