#pragma once
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace percuss::tools {

/// An option's identifier as a user types it: "accel_channel" is "--accel-channel", "survey.example" is
/// "percuss survey --example". An argument's name, "FILE", is returned unchanged.
std::string flag_of(std::string_view id);

/// The identifier of an option or argument: "--accel-channel" is "accel_channel", "FILE" is "FILE".
OptionId option_id(std::string_view flag);

}  // namespace percuss::tools
