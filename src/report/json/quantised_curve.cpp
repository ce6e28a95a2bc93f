#include "report/json/quantised_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report/text/digest.hpp"

namespace percuss::report {

QuantisedCurve quantised_curve(std::span<const double> values, double min_step) {
  constexpr double kLargest = 65534;
  constexpr std::uint16_t kAbsent = 65535;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high)) low = high = 0;
  // Levels in dB, phases and coherences are far from the limits of a double, so that k fits in 16 bits.
  assert(min_step >= 0 && std::isfinite(high - low));
  const double step = std::max(min_step, (high - low) / kLargest);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.size());
  for (const double value : values) {
    const auto k =
        std::isfinite(value) ? static_cast<std::uint16_t>(std::lround(step > 0 ? (value - low) / step : 0)) : kAbsent;
    bytes.push_back(static_cast<std::uint8_t>(k & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(k >> 8U));
  }
  return {.from = low, .step = step, .u16 = base64(bytes)};
}

nlohmann::ordered_json quantised_json(std::span<const double> values, double min_step) {
  QuantisedCurve curve = quantised_curve(values, min_step);
  return {{"from", curve.from}, {"step", curve.step}, {"u16", std::move(curve.u16)}};
}

}  // namespace percuss::report
