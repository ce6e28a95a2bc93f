#pragma once
#include <string>

namespace percuss::accuracy {

/// The software and the processor of the measurement: "percuss 0.1.0, g++ 12.2.0, release build, fftw-3.3.10; Intel(R)
/// …".
std::string build_description();

}  // namespace percuss::accuracy
