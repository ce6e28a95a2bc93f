#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// One data set of a universal file, still as text or bytes.
struct UffSet {
  int number = 0;
  std::string_view text;  // the lines after the set's number; of a binary set, only its header
  std::string_view data;  // the bytes of a binary set
  bool unread = false;    // `data` is not loaded yet (FileBytes::lazy)
  bool binary = false;
  bool big_endian = false;
};

/// Whether these first bytes are the start of a universal file: after blank lines, a line of "    -1" (columns 1 to 6)
/// and blanks.
bool is_universal_file(std::string_view head);

/// The data sets of a universal file, in order. A delimiter is a whole line. Three lengths of a binary set 58 are
/// tried, until a delimiter follows the data: the length in record 7, the length in the set's first line, and the
/// length in record 7 with padding. A lazy file is loaded except for the data of long binary sets 58 with an even
/// abscissa.
/// errors  InputError with file and line: a set is not closed, or its number or length cannot be read.
std::vector<UffSet> split_uff(const FileBytes& file);

/// "file: line 12", the line of `at` in `file`. `at` points into the bytes of `file`.
std::string uff_location(const FileBytes& file, std::string_view at);

/// Takes cells of fixed width off the front of a line. Cells beyond the end of the line are blank.
class UffFields {
 public:
  explicit UffFields(std::string_view line) : rest_(line) {}
  std::string_view take(std::size_t width);
  std::string text(std::size_t width);                     // without surrounding blanks, "NONE" as nothing, UTF-8
  std::optional<std::int64_t> integer(std::size_t width);  // blank is 0; nothing when it is not a whole number
  std::optional<double> number(std::size_t width);         // likewise; also 1.5D+3 and 1.5-101
  bool blank() const { return rest_.find_first_not_of(" \t\r") == std::string_view::npos; }

 private:
  std::string_view rest_;
};

/// Takes the next line off, without its "\n" or "\r\n".
std::string_view take_uff_line(std::string_view& rest);

/// Bytes that record 7 of a set 58 claims for its binary data; nothing when it cannot be read.
std::optional<std::uint64_t> uff_data_bytes(std::string_view record7);

}  // namespace percuss::acquire
