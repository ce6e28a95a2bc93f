#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// One whole analysis (files to classified modes, effort best, one thread) at size n.
struct ScalePoint {
  double n = 0;
  double seconds = 0, time_ratio = 0;  // multiple of the baseline in the same run
  double peak_bytes = 0;               // growth of the memory of the process
  std::size_t modes = 0, modes_sought = 0;
};

struct Scaling {
  std::string of;                  // "samples per hit"
  std::string with;                // fixed sizes
  std::size_t asked = 0;           // the largest size to measure
  std::vector<ScalePoint> points;  // up to `asked`, or to the time limit
  double time_exponent = 0, memory_exponent = 0;
};

/// The least-squares slope of log y over log x in the upper half of the range of log x. Leaves out y of zero or below.
double growth_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// Measures samples 2^10 to 2^24, channels 1 to 1000, hits 1 to 100, modes 1 to 60, files 1 to 10000. Each of the five
/// gets an equal part of `budget_s`, and stops before a size that would exceed its part.
std::vector<Scaling> study_scaling(Extent extent, const TimingOptions& timing, double budget_s);

}  // namespace percuss::accuracy
