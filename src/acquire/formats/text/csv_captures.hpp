#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/formats/text/csv_rows.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "acquire/formats/text/csv_times.hpp"

namespace percuss::acquire {

/// Divides the rows into captures that an instrument wrote one after another. A capture starts
///   - where the time steps back to the first time of its row, within a tenth of the longest earlier capture, or
///   - after a repeated header, unless the time continues evenly over it.
/// `signal` is the column of the force, or of a response if there is no force. The rows stay undivided if a time steps
/// back to another time, or if fewer than half of the parts reach 5 % of the strongest part in `signal`: these are
/// blocks of one recording. If cells of `signal` cannot be read, the parts count as captures.
/// errors  None.
std::vector<CsvRow> divide_into_captures(const CsvTable& table, const std::optional<CsvTimes>& times,
                                         std::size_t signal, const std::vector<CsvRow>& rows);

}  // namespace percuss::acquire
