#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {
inline namespace core {

/// The separators of lines and cells in a text file.
struct CsvDialect {
  char delimiter = ',';  // ',' ';' '\t', or ' ' for any run of blanks
  bool decimal_comma = false;
  bool quoted = false;   // numbers may be in double quotes
  char line_end = '\n';  // '\r' for files of old Macintoshes; "\r\n" is '\n', and the '\r' is removed
};

/// The text after the byte-order mark of UTF-8, if it begins with one.
std::string_view without_byte_order_mark(std::string_view text);

/// Removes the next line from `rest` and returns it without its end. Empty when `rest` is.
std::string_view take_line(std::string_view& rest, char line_end);

/// Removes the next cell from `line`, with its quotes and blanks. Returns false when no cell is left.
bool take_cell(std::string_view& line, const CsvDialect& dialect, std::string_view& cell);

/// All cells of a line without blanks and quotes; at most `limit`.
std::vector<std::string_view> split_cells(std::string_view line, const CsvDialect& dialect, std::size_t limit = 4096);

/// Whether a line has no data: blank, only delimiters, or a comment (# or %).
bool is_skipped(std::string_view line, const CsvDialect& dialect);

/// Lines from the last eighth of the file, where no header is expected. The last line comes first. Blank lines and
/// comments are omitted. At most 64 lines, and at least one where the text has one.
std::vector<std::string_view> probe_lines(std::string_view text, char line_end);

/// CsvDialect::line_end of a text.
char find_line_end(std::string_view text);

/// The dialect of `probes`. The delimiter is the first of ; tab , that most probes contain, otherwise blanks. A comma
/// is no delimiter where every probe holds only numbers like 0,25 and blanks. It is the decimal mark where a cell holds
/// a number with a comma.
CsvDialect find_dialect(const std::vector<std::string_view>& probes, char line_end);

/// Whether commas seem to be both delimiters and decimal marks, as in "0,05,1,5" under two names. Considers the lines
/// of numbers among the first 64 lines of the text, and the probes. All of these conditions must hold:
///   the delimiter is the comma, no quoted number has a comma, and there are at least two names;
///   no line of numbers contains a point;
///   most probes have more cells than there are names, and no line has more than twice as many;
///   the number of cells varies, or is twice the names in every line, or a cell is padded with zeros ("05").
bool has_two_kinds_of_comma(std::string_view text, const std::vector<std::string_view>& probes,
                            const CsvDialect& dialect);

/// Indices of the columns that hold numbers in at least half of `probes`.
std::vector<std::size_t> find_number_columns(const std::vector<std::string_view>& probes, const CsvDialect& dialect);

}  // namespace core
}  // namespace percuss
