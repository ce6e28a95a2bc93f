#pragma once
#include <memory>
#include <string>
#include <vector>

#include "acquire/formats/text/read_csv.hpp"
#include "core/io/input_file.hpp"

namespace percuss::test {

/// A text as if read from the file x.csv.
inline FileBytes csv_bytes(const std::string& text) {
  const auto kept = std::make_shared<const std::string>(text);
  return {.path = "x.csv", .data = {kept, kept->data()}, .size = kept->size()};
}

inline acquire::Record csv_record(const std::string& text, const acquire::ReadOptions& options = {}) {
  return acquire::open_csv(csv_bytes(text), options);
}

inline std::vector<double> force_N(const acquire::Record& record, std::size_t row = 0) {
  std::vector<double> samples(record.rows.at(row).samples);
  record.read_force_N(row, 0, samples);
  return samples;
}

inline std::vector<double> accel_mps2(const acquire::Record& record, std::size_t channel = 0, std::size_t row = 0) {
  std::vector<double> samples(record.rows.at(row).samples);
  record.read_accel_mps2(row, channel, 0, samples);
  return samples;
}

}  // namespace percuss::test
