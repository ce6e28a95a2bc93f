#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace percuss::report {

/// Quantised values of a plotted curve: from + step · k, where u16 holds k as little-endian 16-bit numbers in base64.
/// k = 65535 stands for NaN.
struct QuantisedCurve {
  double from = 0, step = 0;
  std::string u16;
};

/// `step` is the range over 65534, but at least `min_step`, which is 0 or more and below the resolution of the plot.
QuantisedCurve quantised_curve(std::span<const double> values, double min_step);
/// The curve as a JSON object: "from", "step" and "u16".
nlohmann::ordered_json quantised_json(std::span<const double> values, double min_step);

}  // namespace percuss::report
