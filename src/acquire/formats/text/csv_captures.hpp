#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/formats/text/csv_rows.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "acquire/formats/text/csv_times.hpp"

namespace percuss::acquire {

/// Divides the rows into captures that an instrument wrote one after another. A capture starts
///   - where the time steps back to about the first time of its row (a tenth of the longest capture before), or
///   - after a repeated header, unless the time continues evenly over it.
/// `signal` is the column of the force, or of a response where there is no force. The rows stay as they are where a
/// time steps back elsewhere, and where fewer than half of the parts reach 5 % of the strongest one in `signal`: these
/// are blocks of one recording. Cells of `signal` that cannot be read decide nothing.
/// errors  None.
std::vector<CsvRow> divide_into_captures(const CsvTable& table, const std::optional<CsvTimes>& times,
                                         std::size_t signal, const std::vector<CsvRow>& rows);

}  // namespace percuss::acquire
