#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

/// The reason why a column counts as times.
enum class CsvTimeKind {
  named,    // its name or its unit
  clock,    // cells such as 07:08:09.5
  guessed,  // it is the first column and neither a signal nor a count
  counted,  // it is the first column, and its name is one of a count: it may number the samples, but states no rate
};

/// The times that a text states line by line.
struct CsvTimes {
  CsvTimeKind kind = CsvTimeKind::named;
  CsvColumn column;
  double to_s = 1;                                     // s per unit of the cells
  std::vector<double> time_s;                          // [data lines] up to the first cell that is no time
  std::optional<InputError> problem;                   // of that cell
  std::function<int(std::string_view cell)> decimals;  // number of decimals of a cell
};

/// The first column of times of day among the leftmost four. It gives the rate if the text has no other time column.
std::optional<std::size_t> clock_column(const CsvTable& table);

/// Reads the column of times: the named column, else times of day, else a first column that may be the time or a count.
/// Times of day are in s from the first one, and may pass midnight. Nothing if there is no such column.
std::optional<CsvTimes> read_csv_times(const CsvTable& table, const CsvColumns& columns);

}  // namespace percuss::acquire
