#pragma once
#include <vector>

namespace percuss::metrics {

/// The mean of at least one value.
double mean_of(const std::vector<double>& values);

/// The standard error of the mean, from the scatter of the values; 0 for a single value.
double standard_error_of(const std::vector<double>& values);

}  // namespace percuss::metrics
