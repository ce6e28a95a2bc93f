#pragma once
#include <algorithm>
#include <cmath>
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

}  // namespace percuss::test
