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

/// Missing samples of a row: `count` samples from sample `first` of the row on.
struct CsvGap {
  std::size_t first = 0, count = 0;
};

/// One row of a record in a text file: the lines first_line … first_line + lines() − 1 of the data, which are the
/// samples outside the gaps.
struct CsvRow {
  RowInfo info;
  std::size_t first_line = 0;
  std::vector<CsvGap> gaps{};  // ascending, never at either end

  std::size_t lines() const;
};

/// Divides the lines into rows by the columns hit, point and run that exist: a row ends where one of them changes.
/// errors  InputError: a cell is not a whole number, a combination occurs again after another, more than a million
/// rows.
std::vector<CsvRow> find_csv_rows(const CsvTable& table, const CsvColumns& columns);

/// The sampling rate: the user's, else from the times and the header, which must agree. If times of day give no rate,
/// such as whole seconds, it is the header's. If the times show that lines were lost (gaps_of_stamps()), adds
/// the gaps and the missing samples to the rows. Adds assumptions to `notes`.
/// errors  InputError: no rate is stated, two rates disagree (also of two rows), time stamps are uneven or coarse, the
/// rate is implausible.
double find_csv_rate_Hz(const CsvTable& table, const CsvColumns& columns, const std::optional<CsvTimes>& times,
                        std::vector<CsvRow>& rows, const ReadOptions& options, std::vector<Message>& notes);

}  // namespace percuss::acquire
