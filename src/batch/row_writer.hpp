#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "batch/manifest.hpp"

namespace percuss::batch {

/// How the row of a record, and of its FRFs, begins.
inline constexpr std::string_view kRecordRow = R"({"row":"record")";
inline constexpr std::string_view kFrfRow = R"({"row":"frf")";

/// What holds for all rows.
struct BatchTotals {
  std::string version;  // of the percuss that analysed
  BatchHeader head;
  std::size_t records = 0, failed = 0;
};

/// A file of a batch's results, filled row by row; it is in its place after commit() and not before.
class RowWriter {
 public:
  RowWriter() = default;
  virtual ~RowWriter() = default;
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  /// A row as rows_of gives it; `where` it stands, for messages. Rows of a kind that the file does not hold are left
  /// out.
  virtual void add(std::string_view row, const std::string& where) = 0;
  virtual void commit() = 0;
};

/// By the path's extension: .csv, .h5 or else JSON lines. errors  InputError: it exists (without force), cannot be
/// written; .h5 of a batch without FRFs.
std::unique_ptr<RowWriter> row_writer(const std::string& path, const BatchTotals& totals, bool force);

/// The document percuss/batch/1, without its rows: the first line of the JSON lines, with its end.
std::string batch_header_line(const BatchTotals& totals);

}  // namespace percuss::batch
