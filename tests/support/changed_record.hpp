#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::test {

/// The record with change(row, channel, x) applied to the accelerations x of whole rows.
template <class Change>
acquire::Record with_changed_accel(acquire::Record record, Change change) {
  record.contiguous.clear();
  record.read_accel_mps2 = [read = std::move(record.read_accel_mps2), rows = record.rows, change](
                               std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    std::vector<double> x(rows[row].samples);
    read(row, channel, 0, x);
    change(row, channel, x);
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  return record;
}

}  // namespace percuss::test
