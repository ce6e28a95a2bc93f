#pragma once

namespace percuss::report {

/// The product's version, "major.minor.patch".
const char* version();

}  // namespace percuss::report
