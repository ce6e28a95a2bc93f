#include "core/statistics.hpp"

#include <gsl/gsl_statistics_double.h>

#include <cmath>

namespace percuss {

double median(std::vector<double> values) {
  return values.empty() ? 0 : gsl_stats_median(values.data(), 1, values.size());
}

double robust_std(std::vector<double> values) {
  std::vector<double> work(values.size());
  return values.empty() ? 0 : gsl_stats_mad(values.data(), 1, values.size(), work.data());
}

double rms(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace percuss
