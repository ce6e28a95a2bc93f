#pragma once
#include <string>

namespace percuss::accuracy {

/// The software and the processor of the measurement: "percuss 0.1.0, g++ 12.2.0, release, on Intel(R) …".
std::string build_description();

}  // namespace percuss::accuracy
