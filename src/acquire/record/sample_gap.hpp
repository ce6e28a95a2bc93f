#pragma once
#include <cstddef>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Samples that are missing in a row, as the time stamps show: `count` samples from sample `first` of the row on.
/// Readers give a straight line in their place.
struct SampleGap {
  std::size_t row = 0, first = 0, count = 0;
};

/// The gap as a fault of the record; `fs_Hz` is the record's sampling rate.
RecordFault fault_of(const SampleGap& gap, double fs_Hz);

/// The gaps that the record's faults state, ascending by row and sample. A fault outside its row is left out.
std::vector<SampleGap> gaps_of(const Record& record);

}  // namespace percuss::acquire
