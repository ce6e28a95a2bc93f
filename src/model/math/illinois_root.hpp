#pragma once
#include <cmath>

namespace percuss::model {

/// Where f, which has different signs at low and high, crosses zero: regula falsi in the Illinois form, which needs no
/// derivative and never leaves the bracket. `tolerance` is of x.
template <class Function>
double illinois_root(const Function& f, double low, double high, double tolerance) {
  constexpr int kMaxIterations = 200;
  double at_low = f(low), at_high = f(high);
  if (at_low == 0) return low;
  int side = 0;  // of the last crossing: −1 the low end stayed, 1 the high end
  for (int i = 0; i < kMaxIterations && std::abs(high - low) > tolerance && at_high != 0; ++i) {
    const double x = (low * at_high - high * at_low) / (at_high - at_low);
    const double value = f(x);
    if (value == 0) return x;
    if ((value < 0) == (at_high < 0)) {
      high = x;
      at_high = value;
      if (side == -1) at_low /= 2;
      side = -1;
    } else {
      low = x;
      at_low = value;
      if (side == 1) at_high /= 2;
      side = 1;
    }
  }
  return high;
}

}  // namespace percuss::model
