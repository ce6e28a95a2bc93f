#pragma once
#include <vector>

namespace percuss::metrics {

/// Mean of at least one value.
double mean_of(const std::vector<double>& values);

/// Standard error of their mean, from their scatter; 0 for one value, whose scatter is not known.
double standard_error_of(const std::vector<double>& values);

}  // namespace percuss::metrics
