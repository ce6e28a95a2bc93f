#pragma once
#include <cstddef>
#include <limits>
#include <vector>

namespace percuss::report {

/// Values to pixels along one axis of a chart.
struct ChartScale {
  double low = std::numeric_limits<double>::infinity(), high = -low;  // of the values, or of their logarithms
  double from = 0, to = 1;                                            // pixels
  bool logarithmic = false;

  /// The value, or its logarithm on a logarithmic scale.
  double drawn(double value) const;
  /// Extends the range to the value.
  void cover(double value);
  /// Adds a margin, as a fraction of the range, once all values are covered; a range of zero gets some width.
  void settle(double margin);
  double pixel(double value) const { return from + (drawn(value) - low) / (high - low) * (to - from); }
  /// Tick values, about `wanted` steps.
  std::vector<double> ticks(std::size_t wanted) const;
};

/// Round numbers within [low, high], 1, 2 or 5 times a power of ten apart, with about `wanted` steps.
std::vector<double> round_ticks(double low, double high, std::size_t wanted);

}  // namespace percuss::report
