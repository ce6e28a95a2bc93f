#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::python {

enum class NumberType { float64, float32, int8, int16, int32, int64, uint8, uint16, uint32, uint64 };

constexpr std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::int8:
    case NumberType::uint8:
      return 1;
    case NumberType::int16:
    case NumberType::uint16:
      return 2;
    case NumberType::int32:
    case NumberType::uint32:
    case NumberType::float32:
      return 4;
    default:
      return 8;
  }
}

/// Samples of one signal in one row of an array, `step_bytes` apart; they need not be aligned.
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

/// A test whose samples lie in arrays that `owner` keeps alive. Contiguous doubles in SI units are viewed in place;
/// other numbers are converted in blocks as they are read.
struct ArrayTest {
  std::vector<ArrayRow> rows;
  bool has_force = true;
  double fs_Hz = 0;
  bool continuous = false;
  std::vector<std::string> names;  // the force first; may be empty
  std::vector<std::vector<double>> geometry;
  std::shared_ptr<void> owner;
};

/// A checksum of at most 512 numbers, spread over at most 64 signals. It differs if the arrays were refilled or scaled.
std::uint64_t sample_checksum(const ArrayTest& test);

/// The record of the arrays, equal to the record of a file with the same content: the options set units, scales, angles
/// and rate. Throws InputError as record_of_table does. The readers of the record throw InputError for samples that are
/// not finite.
acquire::Record record_of_arrays(const std::shared_ptr<const ArrayTest>& test, const acquire::ReadOptions& options);

}  // namespace percuss::python
