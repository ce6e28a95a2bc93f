#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "acquire/formats/text/csv_times.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// One row of a record in a text file: lines first_line … first_line + info.samples − 1 of the data.
struct CsvRow {
  RowInfo info;
  std::size_t first_line = 0;
};

/// Divides the lines into rows by the columns hit, point and run that exist: a row ends where one of them changes.
/// errors  InputError: a cell is not a whole number, a combination occurs again after another, more than a million
/// rows.
std::vector<CsvRow> find_csv_rows(const CsvTable& table, const CsvColumns& columns);

/// The sampling rate: the user's, else from the times and the header, which must agree. Times of day that give no
/// rate, such as whole seconds, leave it to the header. Adds assumptions to `notes`.
/// errors  InputError: no rate is stated, two rates disagree (also of two rows), time stamps are uneven or coarse, the
/// rate is implausible.
double find_csv_rate_Hz(const CsvTable& table, const CsvColumns& columns, const std::optional<CsvTimes>& times,
                        const std::vector<CsvRow>& rows, const ReadOptions& options, std::vector<Message>& notes);

}  // namespace percuss::acquire
