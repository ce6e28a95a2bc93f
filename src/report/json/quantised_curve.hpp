#pragma once
#include <span>
#include <string>

namespace percuss::report {

/// Numbers for a picture: from + step · k with k the little-endian 16-bit numbers in base64; 65535 is not a number.
struct QuantisedCurve {
  double from = 0, step = 0;
  std::string u16;
};

/// `step` is the range over 65534, or `coarsest` where that is finer than anybody sees.
QuantisedCurve quantised_curve(std::span<const double> values, double coarsest);

}  // namespace percuss::report
