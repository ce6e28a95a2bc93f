#include "report/svg/chart_scale.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::report {

double ChartScale::drawn(double value) const { return logarithmic ? std::log10(value) : value; }

void ChartScale::cover(double value) {
  if (!std::isfinite(drawn(value))) return;
  low = std::min(low, drawn(value));
  high = std::max(high, drawn(value));
}

void ChartScale::settle(double margin) {
  if (!(high >= low)) low = 0, high = 1;
  const double width = high > low ? high - low : std::max(1e-3, 0.02 * std::abs(high));
  low -= margin * width;
  high += margin * width;
  if (!(high > low)) high = low + width;
}

std::vector<double> ChartScale::ticks(std::size_t wanted) const {
  if (!logarithmic) return round_ticks(low, high, wanted);
  std::vector<double> all;
  for (auto decade = static_cast<int>(std::ceil(low - 1)); decade <= high; ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10, decade);
      if ((factor == 1 || high - low < 2) && drawn(value) >= low && drawn(value) <= high) all.push_back(value);
    }
  }
  return all;
}

std::vector<double> round_ticks(double low, double high, std::size_t wanted) {
  if (!(high > low) || wanted == 0 || !std::isfinite(high - low)) return {};
  const double raw = (high - low) / static_cast<double>(wanted);
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  std::vector<double> ticks;
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  for (std::size_t i = 0; first + static_cast<double>(i) <= last; ++i)
    ticks.push_back((first + static_cast<double>(i)) * step);
  return ticks;
}

}  // namespace percuss::report
