#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/csv_dialect.hpp"

namespace percuss::inline core {

/// One column of a text file as its header describes it.
struct CsvColumn {
  std::size_t index = 0;  // among the file's columns, from 0
  std::string name;       // as written, UTF-8; "column 3" where the file has no name
  std::string base;       // the name without its unit: "force" of "force_N" and of "Force (N)"
  std::string unit;       // from a row of units, else from the name; empty: not stated
  bool has_numbers = true;
};

struct CsvHeader {
  std::size_t lines = 0;       // lines before the data, of any kind
  std::size_t data_start = 0;  // byte where the first line of data starts
  bool named = false;
  bool text = true;                // of a text in columns; else the columns are signals of a file of another kind
  std::size_t width = 0;           // cells of the line of names, empty ones too
  std::vector<CsvColumn> columns;  // every column that has a name or numbers, in the file's order
  std::optional<double> fs_Hz;     // stated by a line such as "Sampling Rate(Hz),50"
  std::string fs_line;             // that line, for messages
};

/// What the columns of a text may be.
enum class CsvContent { time_record, frf };

/// Reads what stands before the data. Names are the last line with a text over every column of numbers, units the last
/// one with nothing but units; comment lines count as well, but an ordinary line wins. errors  InputError: no line of
/// numbers; for a time record, the columns are those of an FRF or a spectrum.
CsvHeader read_csv_header(std::string_view text, const CsvDialect& dialect,
                          const std::vector<std::size_t>& number_columns, const std::string& file,
                          CsvContent content = CsvContent::time_record);

/// "force_N" → {"force", "N"}, "Force (N)", "accel [g]", "Force/N", "acc0_m_s2" likewise; no unit: {name, ""}.
struct NameAndUnit {
  std::string base, unit;
};
NameAndUnit split_name(std::string_view name);

/// `text` as UTF-8: unchanged if it is that already, else read as Latin-1.
std::string to_utf8(std::string_view text);

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

}  // namespace percuss::inline core
