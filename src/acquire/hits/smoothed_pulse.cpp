#include "acquire/hits/smoothed_pulse.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::acquire {

std::vector<double> smoothed(std::span<const double> x, double sign, std::size_t h) {
  std::vector<double> out(x.size());
  const double share = 1 / static_cast<double>(2 * h + 1);
  double sum = 0;
  for (std::size_t i = 0; i < std::min(h, x.size()); ++i) sum += sign * x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i + h < x.size()) sum += sign * x[i + h];
    if (i > h) sum -= sign * x[i - h - 1];
    if (i >= h && i + h < x.size()) {
      out[i] = sum * share;
    } else {
      const std::size_t count = std::min(i + h, x.size() - 1) - (i > h ? i - h : 0) + 1;
      out[i] = sum / static_cast<double>(count);
    }
  }
  return out;
}

std::pair<std::size_t, std::size_t> above(std::span<const double> x, double sign, std::size_t peak, double level) {
  std::size_t first = peak, end = peak + 1;
  while (first > 0 && sign * x[first - 1] > level) --first;
  while (end < x.size() && sign * x[end] > level) ++end;
  return {first, end};
}

double width_at_half_peak(std::span<const double> x, double sign, std::size_t peak) {
  const double level = std::abs(x[peak]) / 2;
  std::size_t before = peak, after = peak;
  while (before > 0 && sign * x[before] > level) --before;
  while (after + 1 < x.size() && sign * x[after] > level) ++after;
  const auto part = [&](std::size_t inner, std::size_t outer) {
    const double inside = sign * x[inner], outside = sign * x[outer];
    return inside > outside ? std::min(1.0, (inside - level) / (inside - outside)) : 0;
  };
  if (before == peak || after == peak) return 1.0;
  return static_cast<double>(after - before - 2) + part(before + 1, before) + part(after - 1, after);
}

}  // namespace percuss::acquire
