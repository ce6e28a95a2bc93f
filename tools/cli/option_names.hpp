#pragma once
#include <string>
#include <string_view>

namespace percuss::tools {

/// An option's identifier as it is typed: "accel_channel" is "--accel-channel", "survey.example" is
/// "percuss survey --example".
std::string flag_of(std::string_view id);

}  // namespace percuss::tools
