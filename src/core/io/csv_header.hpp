#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_text.hpp"

namespace percuss {
inline namespace core {

/// A column of a text file as described by its header.
struct CsvColumn {
  std::size_t index = 0;  // among the file's columns, from 0
  std::string name;       // as written, UTF-8; "column 3" for a column without a name
  std::string base;       // the name without its unit: "force" of "force_N" and of "Force (N)"
  std::string unit;       // from a row of units, else from the name; empty: not stated
  bool has_numbers = true;
  std::string shape{};  // of an array in a file that is not text, for messages: "4096x1"
};

struct CsvHeader {
  std::size_t lines = 0;       // all lines before the data
  std::size_t data_start = 0;  // byte offset of the first line of data
  bool named = false;
  bool text = true;                // false where the columns are the signals of a file that is not text
  std::size_t width = 0;           // cells of the line of names, including empty cells
  std::vector<CsvColumn> columns;  // every column with a name or numbers, in the order of the file
  std::optional<double> fs_Hz;     // stated by a line such as "Sampling Rate(Hz),50"
  std::string fs_line;             // that line, for messages
};

/// The possible contents of a text in columns.
enum class CsvContent { time_record, frf };

/// A text that is no table, such as a README.
class NoNumbers : public InputError {
 public:
  using InputError::InputError;
};

/// Reads the lines before the data. The names are in the last line with text over every column of numbers, the units in
/// the last line with nothing but units. Comment lines count as well, but ordinary lines take precedence.
/// errors  NoNumbers: no line of numbers; InputError: for a time record, the columns of an FRF or a spectrum
CsvHeader read_csv_header(std::string_view text, const CsvDialect& dialect,
                          const std::vector<std::size_t>& number_columns, const std::string& file,
                          CsvContent content = CsvContent::time_record);

/// "force_N" → {"force", "N"}, "Force (N)", "accel [g]", "Force/N", "acc0_m_s2" likewise; no unit: {name, ""}.
struct NameAndUnit {
  std::string base, unit;
};
NameAndUnit split_name(std::string_view name);

}  // namespace core
}  // namespace percuss
