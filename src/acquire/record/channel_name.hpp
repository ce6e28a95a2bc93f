#pragma once
#include <cstddef>
#include <string>

namespace percuss::acquire {

/// The name of an acceleration channel without one: "accel 1" for channel 0.
std::string channel_name(std::size_t index);

}  // namespace percuss::acquire
