#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::inline core {

/// How a text file separates its lines and cells.
struct CsvDialect {
  char delimiter = ',';  // ',' ';' '\t', or ' ' for any run of blanks
  bool decimal_comma = false;
  bool quoted = false;   // cells of numbers may stand in double quotes
  char line_end = '\n';  // '\r' for files of old Macintoshes; "\r\n" is '\n' with a '\r' that is cut off
};

/// Takes the next line off `rest`, without its end. Empty when `rest` is.
std::string_view take_line(std::string_view& rest, char line_end);

/// Takes the next cell off `line`, quotes and blanks left on; returns false when there is none left.
bool take_cell(std::string_view& line, const CsvDialect& dialect, std::string_view& cell);

/// All cells of a line, blanks and quotes off; at most `limit`.
std::vector<std::string_view> split_cells(std::string_view line, const CsvDialect& dialect, std::size_t limit = 4096);

/// Lines without data wherever they stand: blank, delimiters only, or a comment (# or %).
bool is_skipped(std::string_view line, const CsvDialect& dialect);

/// Lines from the last eighth of the file, where headers no longer are, last one first; at least one and at most 64
/// where there are any, none of them blank or a comment.
std::vector<std::string_view> probe_lines(std::string_view text, char line_end);

char find_line_end(std::string_view text);

/// The dialect that `probes` are written in: the delimiter is the first of ; tab , that most of them contain, else
/// blanks. A comma is the decimal mark when the delimiter is another one, or when all that a line holds are words like
/// 0,25 and blanks.
CsvDialect find_dialect(const std::vector<std::string_view>& probes, char line_end);

/// True where commas seem to stand both between the cells and for the decimal point, so that nobody can tell which is
/// which: "0,05,1,5" under two names. No line of numbers looked at (the text's first and the probes) holds a point,
/// most have more cells than the last line of names, and their numbers are as uneven as fractions make them: twice the
/// names, changing, or padded with zeros.
bool has_two_kinds_of_comma(std::string_view text, const std::vector<std::string_view>& probes,
                            const CsvDialect& dialect);

/// Indices of columns that hold numbers in at least half of `probes`.
std::vector<std::size_t> find_number_columns(const std::vector<std::string_view>& probes, const CsvDialect& dialect);

}  // namespace percuss::inline core
