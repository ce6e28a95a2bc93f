#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "acquire/formats/text/csv_layout.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The lines of numbers of a text file. Opening counts the lines and their cells. Numbers are parsed when their column
/// is first read, in blocks of lines, and kept: other columns and blocks cost nothing.
class CsvTable {
 public:
  /// `header` states where the data starts; each line from there on is data, blank, a comment or a repeated line of the
  /// header, as instruments write before each capture.
  /// errors  InputError: a line with too few or too many cells, a line too long.
  CsvTable(FileBytes bytes, CsvDialect dialect, CsvHeader header, const std::vector<std::size_t>& number_columns);
  CsvTable(FileBytes bytes, CsvLayout layout)
      : CsvTable(std::move(bytes), layout.dialect, std::move(layout.header), layout.number_columns) {}

  std::size_t lines() const { return lines_; }
  const CsvHeader& header() const { return header_; }
  const CsvDialect& dialect() const { return dialect_; }
  const std::string& path() const { return bytes_.path; }
  /// The data lines that follow a repeated line of the header, in ascending order.
  const std::vector<std::size_t>& lines_after_header() const { return lines_after_header_; }

  /// Numbers of data lines first … first + out.size() − 1, as stored. `index` as in CsvColumn. Several threads may call
  /// at the same time.
  /// errors  InputError: a cell is not a finite number; names line and column.
  void read(std::size_t index, std::size_t first, std::span<double> out) const;

  /// Calls visit(n, cell) for every data line n, with the column's cell as written, including quotes and blanks.
  void for_each_cell(std::size_t index,
                     const std::function<void(std::size_t line, std::string_view cell)>& visit) const;

  /// The cell of a data line as written; empty where there is none. Slow for late lines: counts lines from the start.
  std::string_view cell(std::size_t index, std::size_t line) const;

  /// "x.csv: line 12, column 3 (force_N)".
  std::string place(std::size_t line, std::optional<std::size_t> index = {}) const;

 private:
  struct Block {
    std::mutex mutex;  // not std::call_once: thread sanitizers hang when its function throws
    std::vector<double> numbers;
  };
  using Column = std::vector<Block>;

  std::string_view data() const { return bytes_.view().substr(header_.data_start); }
  void find_header_lines(const std::vector<std::size_t>& number_columns);
  bool repeats_header(std::string_view line) const;
  bool is_data(std::string_view line) const;
  void count_lines(std::size_t fewest, std::size_t most);
  Column& column(std::size_t index) const;
  void parse_block(std::size_t index, std::size_t block, Block& into) const;

  FileBytes bytes_;
  CsvDialect dialect_;
  CsvHeader header_;
  std::vector<std::string_view> header_lines_;  // lines with text over a column of numbers, which are never data
  bool header_like_number_ = false;             // one of header_lines_ starts like a number
  std::vector<std::size_t> lines_after_header_;
  std::size_t lines_ = 0;
  std::vector<std::size_t> block_start_;  // offset of each block's first line from the start of the data, in bytes
  mutable std::mutex columns_mutex_;
  mutable std::map<std::size_t, std::unique_ptr<Column>> columns_;
};

}  // namespace percuss::acquire
