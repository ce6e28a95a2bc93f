#include "acquire/record/stated_date.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kDateHead_bytes = std::size_t{1} << 16U, kMaxHeadLines = 400, kMaxDate_bytes = 60;

constexpr std::string_view kBlanks{" \t\r\n\"'\0", 7};  // with the NUL that ends texts of sound files

std::string_view trimmed(std::string_view text, std::string_view blanks = kBlanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < kMaxHeadLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// Data set 58 begins with five lines of text; the third one is the date.
std::string uff_date(const std::vector<std::string_view>& lines) {
  for (std::size_t i = 1; i + 3 < lines.size(); ++i) {
    const std::string_view number = trimmed(lines[i]);
    if (trimmed(lines[i - 1]) == "-1" && (number == "58" || number.starts_with("58b")))
      return plausible_date(lines[i + 3]);
  }
  return "";
}

constexpr std::string_view kAfterWord{" \t,;:=\""};

// Text before and after a word in a line.
struct SplitLine {
  std::string before;  // lower case
  std::string_view after;
};
// Nothing for a line that does not have the word within its first 40 characters.
std::optional<SplitLine> split_at_word(std::string_view line, std::string_view word) {
  line = trimmed(line, " \t\r\n\"'#%;/*");
  const std::string lower = lower_case(std::string(line.substr(0, std::min<std::size_t>(line.size(), 40))));
  const std::size_t at = lower.find(word);
  if (at == std::string::npos || (at > 0 && lower[at - 1] != ' ' && lower[at - 1] != '_')) return std::nullopt;
  const std::size_t end = at + word.size();
  if (end >= line.size() || kAfterWord.find(line[end]) == std::string_view::npos) return std::nullopt;
  return SplitLine{.before = std::string(trimmed(std::string_view(lower).substr(0, at), " _")),
                   .after = trimmed(line.substr(end), " \t\r\n,;:=\"")};
}

// The date in a line such as "# Test date: 2026-11-20"; empty for other lines, such as the date of a calibration.
std::string_view date_in_line(std::string_view line) {
  constexpr std::array kWords = {"date/time",    "date and time",       "datetime",
                                 "date of test", "date of measurement", "date"};
  constexpr std::array kOfTest = {"", "test", "measurement", "recording", "acquisition", "start"};
  for (const char* const word : kWords) {
    const std::optional<SplitLine> split = split_at_word(line, word);
    if (!split) continue;
    const bool of_test = std::find(kOfTest.begin(), kOfTest.end(), split->before) != kOfTest.end();
    return of_test && !split->after.starts_with("of ") ? split->after : std::string_view{};
  }
  return {};
}

std::string_view time_in_line(std::string_view line) {
  const std::optional<SplitLine> split = split_at_word(line, "time");
  return split ? split->after : std::string_view{};
}

// "2026/04/09 15:54:47" of "2026/04/09\",\"15:54:47": delimiters of the text are no part of the date.
std::string without_delimiters(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool delimiter = std::string_view("\",;\t ").find(c) != std::string_view::npos;
    if (!delimiter) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  return out;
}

std::string text_date(const std::vector<std::string_view>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string date = plausible_date(without_delimiters(date_in_line(lines[i])));
    if (date.empty()) continue;
    // LabVIEW writes the time of day in the next line.
    const std::string_view time = i + 1 < lines.size() ? time_in_line(lines[i + 1]) : std::string_view{};
    const bool clock = time.find(':') != std::string_view::npos;
    const std::string both = clock ? date + " " + std::string(time.substr(0, time.find_first_of(".,\t"))) : date;
    return plausible_date(both);
  }
  return "";
}

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

std::string sound_date(std::string_view head) {
  constexpr std::size_t kFirstChunk = 12, kBextDate = 320, kBextDate_bytes = 10, kBextTime_bytes = 8;
  for (std::size_t at = kFirstChunk; at + 8 <= head.size();) {
    const std::string_view id = head.substr(at, 4);
    const std::size_t size = little_endian(head.substr(at + 4, 4));
    const std::string_view chunk = head.substr(at + 8, size);
    if (id == "bext" && chunk.size() >= kBextDate + kBextDate_bytes + kBextTime_bytes) {
      return plausible_date(std::string(chunk.substr(kBextDate, kBextDate_bytes)) + " " +
                            std::string(chunk.substr(kBextDate + kBextDate_bytes, kBextTime_bytes)));
    }
    if (id == "LIST" && chunk.starts_with("INFO")) {
      const std::size_t word = chunk.find("ICRD");
      if (word != std::string_view::npos && word + 8 <= chunk.size())
        return plausible_date(chunk.substr(word + 8, little_endian(chunk.substr(word + 4, 4))));
    }
    at += 8 + size + size % 2;
  }
  return "";
}

}  // namespace

std::string plausible_date(std::string_view text) {
  text = trimmed(text);
  const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto printable = [](unsigned char c) { return c >= 0x20 && c < 0x7F; };
  if (text.size() > kMaxDate_bytes || std::count_if(text.begin(), text.end(), digit) < 3 ||
      !std::all_of(text.begin(), text.end(), printable))
    return "";
  return std::string(text);
}

std::string stated_date(std::string_view head) {
  if (head.starts_with("MATLAB 5.0") || head.starts_with("MATLAB 7.3")) return "";  // states when the file was written
  if (head.starts_with("RIFF") || head.starts_with("RF64")) return sound_date(head);
  if (head.find('\0') != std::string_view::npos) return "";
  const std::vector<std::string_view> lines = lines_of(head);
  const bool universal =
      std::any_of(lines.begin(), lines.end(), [](std::string_view line) { return trimmed(line) == "-1"; });
  return universal ? uff_date(lines) : text_date(lines);
}

std::string stated_date_of_file(const std::string& path) {
  if (path == "-") return "";
  try {
    return stated_date(first_bytes(path, kDateHead_bytes));
  } catch (const InputError&) {
    return "";  // data in memory, or a file that is gone
  }
}

std::string date_of(const InputFile& file) { return file.date.empty() ? stated_date_of_file(file.path) : file.date; }

std::string common_date_of(const std::vector<InputFile>& files) {
  std::string common;
  for (const InputFile& file : files) {
    const std::string date = date_of(file);
    if (date.empty() || (!common.empty() && date != common)) return "";
    common = date;
  }
  return common;
}

}  // namespace percuss::acquire
