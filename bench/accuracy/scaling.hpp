#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// One whole analysis (files to classified modes, effort best, one thread) of so many samples, channels, …
struct ScalePoint {
  double n = 0;
  double seconds = 0, time_ratio = 0;  // over bare transforms and reading in the same run
  double peak_bytes = 0;               // what the process's memory grew by
  std::size_t modes = 0, modes_sought = 0;
};

struct Scaling {
  std::string of;    // "samples per hit"
  std::string with;  // what stayed as it was
  std::size_t asked = 0;
  std::vector<ScalePoint> points;  // up to `asked`, or as far as the time allowed
  double time_exponent = 0, memory_exponent = 0;
};

/// The slope of log y over log x by least squares, of the points in the upper half of log x; values not above zero are
/// left out.
double growth_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// Samples 2^10 to 2^24, channels 1 to 1000, hits 1 to 100, modes 1 to 60, files 1 to 10000; each until the next size
/// would take longer than what is left of `budget_s` for it.
std::vector<Scaling> study_scaling(Extent extent, const TimingOptions& turns, double budget_s);

}  // namespace percuss::accuracy
