#include "metrics/protocol/resolution.hpp"

#include <cmath>

namespace percuss::metrics {

double reading_std(double step) { return step / std::sqrt(12.0); }

double round_to_step(double value, double step) {
  if (!(step > 0)) return value;
  // Where 1/step is a whole number, division by it gives 30.125, not 30.125000000000004.
  const double per_unit = std::round(1 / step);
  if (std::abs(per_unit * step - 1) < 1e-12) return std::round(value * per_unit) / per_unit;
  return std::round(value / step) * step;
}

}  // namespace percuss::metrics
