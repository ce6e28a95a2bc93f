#pragma once
#include <cstddef>
#include <limits>
#include <vector>

namespace percuss::report {

/// Values to pixels along one axis of a chart.
struct ChartScale {
  double low = std::numeric_limits<double>::infinity(), high = -low;  // of the values, logarithms where so drawn
  double from = 0, to = 1;                                            // pixels
  bool logarithmic = false;

  double drawn(double value) const;
  void cover(double value);
  /// Once all values are covered: a margin, as a fraction of their range, and some width in any case.
  void settle(double margin);
  double pixel(double value) const { return from + (drawn(value) - low) / (high - low) * (to - from); }
  /// Round values, about `wanted` steps.
  std::vector<double> ticks(std::size_t wanted) const;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) that cover low to high with about `wanted` steps, those inside
/// only.
std::vector<double> round_ticks(double low, double high, std::size_t wanted);

}  // namespace percuss::report
