#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::python {

enum class NumberType { float64, float32, int8, int16, int32, int64, uint8, uint16, uint32, uint64 };

/// Numbers of one signal in one row, somewhere in memory: `step_bytes` from one to the next, aligned or not.
struct StridedSamples {
  const std::byte* first = nullptr;
  std::ptrdiff_t step_bytes = 0;
  std::size_t samples = 0;
  NumberType type = NumberType::float64;
};

struct ArrayRow {
  StridedSamples force;
  std::vector<StridedSamples> accel;  // [channels]
  int point = 0;
};

/// A test whose samples lie in arrays of another program, which `owner` keeps alive. Nothing is copied: numbers are
/// converted a stretch at a time as they are read, or looked at where they are doubles in SI side by side.
struct ArrayTest {
  std::vector<ArrayRow> rows;
  bool has_force = true;
  double fs_Hz = 0;
  bool continuous = false;
  std::vector<std::string> names;  // force first; may be empty
  std::vector<std::vector<double>> geometry;
  std::shared_ptr<void> owner;
};

/// A sum over some hundred of the numbers, spread over all signals: another one where arrays were filled anew or
/// scaled.
std::uint64_t sample_checksum(const ArrayTest& test);

/// As a file of the same content would be opened: units, scales, angles and rate as the options say.
/// errors  InputError: as record_of_table; the readers throw it for samples that are not finite.
acquire::Record record_of_arrays(const std::shared_ptr<const ArrayTest>& test, const acquire::ReadOptions& options);

}  // namespace percuss::python
