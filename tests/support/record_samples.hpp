#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::test {

/// All force samples of a row.
inline std::vector<double> force_N(const acquire::Record& record, std::size_t row = 0) {
  std::vector<double> samples(record.rows.at(row).samples);
  record.read_force_N(row, 0, samples);
  return samples;
}

/// All acceleration samples of a channel in a row.
inline std::vector<double> accel_mps2(const acquire::Record& record, std::size_t channel = 0, std::size_t row = 0) {
  std::vector<double> samples(record.rows.at(row).samples);
  record.read_accel_mps2(row, channel, 0, samples);
  return samples;
}

}  // namespace percuss::test
