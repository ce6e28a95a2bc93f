#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace percuss::test {

/// The index of the sample with the largest magnitude; of equal ones, the first. 0 if x is empty.
inline std::size_t largest_sample(const std::vector<double>& x) {
  const auto smaller_magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(x.begin(), x.end(), smaller_magnitude) - x.begin());
}

/// The largest magnitude; 0 if x is empty.
inline double largest_magnitude(const std::vector<double>& x) { return x.empty() ? 0 : std::abs(x[largest_sample(x)]); }

/// The largest magnitude of a[k] − b[k]. Expects equal lengths.
inline double largest_difference(const std::vector<std::complex<double>>& a,
                                 const std::vector<std::complex<double>>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

}  // namespace percuss::test
