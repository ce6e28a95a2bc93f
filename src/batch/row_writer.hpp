#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "batch/manifest.hpp"
#include "core/io/csv_cell.hpp"

namespace percuss::batch {

/// The first bytes of the row of a record, and of a row of FRFs.
inline constexpr std::string_view kRecordRow = R"({"row":"record")";
inline constexpr std::string_view kFrfRow = R"({"row":"frf")";

/// Data of the whole batch, for the head of a file of results.
struct BatchTotals {
  std::string version;  // of percuss at the time of the analysis
  BatchHeader head;
  std::size_t records = 0, failed = 0;
};

/// Writes the results of a batch row by row. The file appears with commit().
class RowWriter {
 public:
  RowWriter() = default;
  virtual ~RowWriter() = default;
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  /// Adds a row of rows_of. `where` is its place for messages. Ignores rows of a kind that the file does not hold.
  virtual void add(std::string_view row, const std::string& where) = 0;
  virtual void commit() = 0;
};

/// The writer for an extension: .csv, .h5, otherwise JSON lines.
/// errors  InputError: the file exists (without force) or cannot be written; .h5 of a batch without FRFs
std::unique_ptr<RowWriter> row_writer(const std::string& path, const BatchTotals& totals, bool force,
                                      CsvFormulas formulas = CsvFormulas::neutralise);

/// The first of the JSON lines, with its line end: the document percuss/batch/1 without its rows.
std::string batch_header_line(const BatchTotals& totals);

}  // namespace percuss::batch
