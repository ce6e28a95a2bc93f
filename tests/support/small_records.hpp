#pragma once
#include <string>
#include <vector>

namespace percuss::test {

/// One hit on one mode at 200 Hz with 1 % damping, 4096 Hz, 0.5 s, without noise. Tests write it to files of various
/// layouts.
struct SmallRecord {
  std::vector<double> time_s, force_N, accel_mps2;
};
SmallRecord small_record();

/// Writes columns of numbers as CSV, below the line `header` unless `header` is empty.
void write_columns(const std::string& path, const std::string& header, const std::vector<std::vector<double>>& columns);

}  // namespace percuss::test
