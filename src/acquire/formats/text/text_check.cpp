#include "acquire/formats/text/text_check.hpp"

#include <algorithm>
#include <array>

#include "acquire/formats/text/json_input.hpp"
#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"

namespace percuss::acquire {
namespace {

struct Magic {
  std::string_view start, kind;
};

// Files of instruments and programs that percuss does not read, by their first bytes.
constexpr std::array kNotReadable = {
    Magic{"TDSm", "a TDMS file"},
    Magic{"PK\x03\x04", "a zip archive (such as xlsx or npz)"},
    Magic{"\xD0\xCF\x11\xE0", "an old Excel file"},
    Magic{"\x1F\x8B", "a gzip archive"},
    Magic{"\x93NUMPY", "a NumPy array"},
    Magic{"%PDF", "a PDF document"},
};

constexpr std::string_view kJournalStart = "PERCUSSJ";  // docs/reference/journal.md

constexpr std::size_t kLineLimit_bytes = std::size_t{1} << 20U;

// Checks the lines from `first` on, until at most 1 MiB remains. Returns where it stopped, at the start of a line.
// Finds only the last line end in each window of 1 MiB, so that it reads few bytes of short lines.
std::size_t require_short_lines_from(std::size_t first, std::string_view text, std::string_view line_ends,
                                     const std::string& name) {
  while (text.size() - first > kLineLimit_bytes) {
    const std::size_t last = text.substr(first, kLineLimit_bytes + 1).find_last_of(line_ends);
    if (last == std::string_view::npos) {
      const std::string_view before = text.substr(0, first);
      const auto line = 1 + std::count(before.begin(), before.end(), find_line_end(before));
      throw InputError("a line of more than 1 MiB", name + ": line " + std::to_string(line),
                       "save one line per sample");
    }
    first += last + 1;
  }
  return first;
}

}  // namespace

void require_text(std::string_view head, const std::string& name) {
  for (const Magic& magic : kNotReadable) {
    if (head.starts_with(magic.start))
      throw InputError(std::string(magic.kind) + " cannot be read", name, "save it as CSV or HDF5");
  }
  if (head.starts_with(kJournalStart))
    throw InputError("this is the journal of a recording", name, "resume the recording", {"record.resume"});
  if (head.empty()) throw InputError("the file is empty", name, "record or export it again");
  const auto starts = [&](std::string_view bytes) { return head.substr(0, bytes.size()) == bytes; };
  if (starts("\xFF\xFE") || starts("\xFE\xFF")) throw InputError("this is UTF-16 text", name, "save it as UTF-8");
  refuse_json(head, name);
  const auto control = std::count_if(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v' && c != 0x1A;
  });
  if (control > 0)
    throw InputError("this is neither text nor a format that percuss knows", name, "save it as CSV or HDF5");
}

void require_short_lines(std::string_view text, char line_end, const std::string& name) {
  require_short_lines_from(0, text, {&line_end, 1}, name);
}

void LineLengthCheck::operator()(std::string_view text) {
  checked_ = require_short_lines_from(checked_, text, "\r\n", name_);
}

}  // namespace percuss::acquire
