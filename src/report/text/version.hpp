#pragma once

namespace percuss {

/// The product's version, "major.minor.patch".
const char* version();

}  // namespace percuss
