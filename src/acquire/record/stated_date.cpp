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
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kDateHead_bytes = std::size_t{1} << 16U, kMaxHeadLines = 400, kMaxDate_bytes = 60;

constexpr std::string_view kBlanks{" \t\r\n\"'\0", 7};  // with the NUL that ends texts of sound files

std::string_view stripped(std::string_view text, std::string_view blanks = kBlanks) {
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
    const std::string_view number = stripped(lines[i]);
    if (stripped(lines[i - 1]) == "-1" && (number == "58" || number.starts_with("58b")))
      return plausible_date(lines[i + 3]);
  }
  return "";
}

constexpr std::size_t kNowhere = std::string_view::npos;
constexpr std::string_view kAfterWord{" \t,;:=\""};

// Text before and after a word in a line.
struct SplitLine {
  std::string before;  // lower case
  std::string_view after;
};
// Nothing for a line that does not have the word within its first 40 characters.
std::optional<SplitLine> split_at_word(std::string_view line, std::string_view word) {
  line = stripped(line, " \t\r\n\"'#%;/*");
  const std::string lower = lower_case(std::string(line.substr(0, std::min<std::size_t>(line.size(), 40))));
  const std::size_t at = lower.find(word);
  if (at == std::string::npos || (at > 0 && lower[at - 1] != ' ' && lower[at - 1] != '_')) return std::nullopt;
  const std::size_t end = at + word.size();
  if (end >= line.size() || kAfterWord.find(line[end]) == std::string_view::npos) return std::nullopt;
  return SplitLine{.before = std::string(stripped(std::string_view(lower).substr(0, at), " _")),
                   .after = stripped(line.substr(end), " \t\r\n,;:=\"")};
}

// The end of the digits that begin at `at`.
std::size_t end_of_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

// The end of a date of three numbers ("14.03.2026", "3/14/26", "2026-03-14") that begins at `at`; 0 if none does.
std::size_t end_of_numeric_date(std::string_view text, std::size_t at) {
  std::array<std::size_t, 3> digits{};
  char separator = 0;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t end = end_of_digits(text, at);
    digits.at(i) = end - at;
    at = end;
    if (i + 1 == digits.size()) break;
    if (at >= text.size() || std::string_view("./-").find(text[at]) == std::string_view::npos) return 0;
    if (separator != 0 && text[at] != separator) return 0;
    separator = text[at++];
    // "14. 3. 2026"
    if (separator == '.' && at < text.size() && text[at] == ' ') ++at;
  }
  const auto one_or_two = [](std::size_t count) { return count == 1 || count == 2; };
  const bool year_first = digits[0] == 4 && one_or_two(digits[1]) && one_or_two(digits[2]);
  const bool year_last = one_or_two(digits[0]) && one_or_two(digits[1]) && (digits[2] == 2 || digits[2] == 4);
  return year_first || year_last ? at : 0;
}

// The end of a date whose month is a word ("14-MAR-26", "14 March 2026") that begins at `at`; 0 if none does.
std::size_t end_of_worded_date(std::string_view text, std::size_t at) {
  constexpr std::array kMonths = {"jan", "feb", "mar", "maer", "apr", "may", "mai", "jun",
                                  "jul", "aug", "sep", "oct",  "okt", "nov", "dec", "dez"};
  const auto skip = [&](std::string_view characters) {
    at = std::min(text.find_first_not_of(characters, at), text.size());
  };
  const std::size_t day_end = end_of_digits(text, at);
  if (day_end == at || day_end - at > 2) return 0;
  at = day_end;
  skip(". -");
  std::size_t end = at;
  while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
  const std::string word = lower_case(std::string(text.substr(at, end - at)));
  if (std::none_of(kMonths.begin(), kMonths.end(), [&](const char* month) { return word.starts_with(month); }))
    return 0;
  at = end;
  skip(". ,-");
  end = end_of_digits(text, at);
  return end - at == 2 || end - at == 4 ? end : 0;
}

// " 09:12:05 UTC" after a date; empty for other text. A fraction of a second is left out.
std::string time_after_date(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of("\",;\t T"), text.size()));
  const std::size_t hour = end_of_digits(text, 0);
  if (hour == 0 || hour > 2 || hour + 1 >= text.size() || text[hour] != ':' || !is_digit(text[hour + 1])) return "";
  std::size_t end = hour;
  while (end < text.size() && text[end] == ':') end = end_of_digits(text, end + 1);
  std::string time = " " + std::string(text.substr(0, end));
  if (end + 1 < text.size() && (text[end] == '.' || text[end] == ',')) end = end_of_digits(text, end + 1);
  const std::string_view rest = text.substr(end);
  if (rest.size() > 2 && (rest[0] == '+' || rest[0] == '-') && is_digit(rest[1]))
    return time + std::string(rest.substr(0, std::min(rest.find_first_not_of("0123456789:", 1), rest.size())));
  for (const char* const zone : {"Z", " AM", " PM", " UTC", " GMT", " CEST", " CET", " MESZ", " MEZ"}) {
    if (rest.starts_with(zone)) return time + zone;
  }
  return time;
}

// The first date of a text: the date unchanged, because no order of day and month is assumed; then a blank and the time
// of day to whole seconds. Empty without a date, as for the names of columns and for a time of day alone.
std::string calendar_date(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_digit(text[at]) || (at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0)) continue;
    const std::size_t end = std::max(end_of_numeric_date(text, at), end_of_worded_date(text, at));
    if (end > 0 && (end == text.size() || !is_digit(text[end])))
      return std::string(text.substr(at, end - at)) + time_after_date(text.substr(end));
  }
  return "";
}

// Replaces German umlauts and sharp s (UTF-8 or Latin-1) by ASCII letters, because the words searched for are ASCII:
// "Prüfdatum" becomes "Pruefdatum".
std::string without_umlauts(std::string_view text) {
  constexpr std::array<std::array<std::string_view, 3>, 5> kLetters{{{"\xC3\xA4", "\xE4", "ae"},
                                                                     {"\xC3\xB6", "\xF6", "oe"},
                                                                     {"\xC3\xBC", "\xFC", "ue"},
                                                                     {"\xC3\x9C", "\xDC", "Ue"},
                                                                     {"\xC3\x9F", "\xDF", "ss"}}};
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 0;
    for (const auto& [utf8, latin1, ascii] : kLetters) {
      if (taken == 0 && (text.starts_with(utf8) || text.starts_with(latin1))) {
        out += ascii;
        taken = text.starts_with(utf8) ? utf8.size() : latin1.size();
      }
    }
    if (taken == 0) out += text.front();
    text.remove_prefix(std::max<std::size_t>(taken, 1));
  }
  return out;
}

// The date in a line such as "Messdatum;14.03.2026 09:12:05" or "Start time: 2026-03-14 09:12:05". These words can also
// precede the names of columns or a duration: only a calendar date counts.
std::string calendar_date_in_line(std::string_view line) {
  constexpr std::size_t kHead_bytes = 200;
  constexpr std::array kWords = {
      // German
      "datum/uhrzeit", "datum/zeit", "datum und uhrzeit", "datum und zeit", "datum, uhrzeit", "datum der messung",
      "datum der aufnahme", "datum der aufzeichnung", "datum der pruefung", "datum des tests", "datum des versuchs",
      "datum", "messdatum", "pruefdatum", "testdatum", "versuchsdatum", "aufnahmedatum", "aufzeichnungsdatum",
      "erfassungsdatum", "startdatum", "startzeitpunkt", "startzeit", "aufnahmezeit", "aufnahmezeitpunkt",
      "aufzeichnungszeit", "messzeitpunkt", "messbeginn", "beginn der messung", "zeitstempel", "gemessen am",
      "aufgenommen am",
      // English
      "start time", "starttime", "startdate", "start of measurement", "start of recording", "date of recording",
      "date of acquisition", "date recorded", "date measured", "testdate", "recording time", "acquisition time",
      "measurement time", "test time", "time of test", "time of measurement", "time of recording", "timestamp",
      "time stamp", "recorded on", "recorded at", "recorded", "measured on", "measured at"};
  line = stripped(line, " \t\r\n\"'#%;/*");
  if (line.empty() || is_digit(line.front())) return "";
  const std::string text = without_umlauts(line.substr(0, kHead_bytes));
  std::string lower = lower_case(text);
  std::replace(lower.begin(), lower.end(), '_', ' ');
  for (const std::string_view word : kWords) {
    if (lower.size() <= word.size() || !lower.starts_with(word) || kAfterWord.find(lower[word.size()]) == kNowhere)
      continue;
    const std::string_view after = stripped(std::string_view(text).substr(word.size()), " \t\r\n,;:=\"");
    const std::array kOther = {"der ", "des ", "von ", "of "};  // "Datum der Kalibrierung"
    const bool of_other =
        std::any_of(kOther.begin(), kOther.end(), [&](const char* other) { return after.starts_with(other); });
    if (!of_other) return calendar_date(after);
  }
  return "";
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
  for (const char* const word : {"time", "uhrzeit", "zeit"}) {
    if (const std::optional<SplitLine> split = split_at_word(line, word)) return split->after;
  }
  return {};
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

// `date` with the time of day in the line that follows it, as LabVIEW writes it.
std::string with_time_of_next_line(const std::string& date, const std::vector<std::string_view>& lines, std::size_t i) {
  const std::string_view time = i + 1 < lines.size() ? time_in_line(lines[i + 1]) : std::string_view{};
  const bool clock = !time.empty() && is_digit(time.front()) && time.find(':') != kNowhere;
  if (!clock || date.find(':') != std::string::npos) return date;
  return plausible_date(date + " " + std::string(time.substr(0, time.find_first_of(".,;\t"))));
}

std::string text_date(const std::vector<std::string_view>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string date = plausible_date(without_delimiters(date_in_line(lines[i])));
    if (!date.empty()) return with_time_of_next_line(date, lines, i);
  }
  // A line "Test date" counts before a line "Timestamp": the date of a time stamp may be the date of an export.
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string date = plausible_date(calendar_date_in_line(lines[i]));
    if (!date.empty()) return with_time_of_next_line(date, lines, i);
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
  text = stripped(text);
  const auto printable = [](unsigned char c) { return c >= 0x20 && c < 0x7F; };
  if (text.size() > kMaxDate_bytes || std::count_if(text.begin(), text.end(), is_digit) < 3 ||
      !std::all_of(text.begin(), text.end(), printable))
    return "";
  return std::string(text);
}

std::string stated_date(std::string_view head) {
  if (head.starts_with("MATLAB 5.0") || head.starts_with("MATLAB 7.3")) return "";  // states when the file was written
  if (head.starts_with("RIFF") || head.starts_with("RF64")) return sound_date(head);
  if (head.find('\0') != std::string_view::npos) return "";
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);  // byte-order mark
  const std::vector<std::string_view> lines = lines_of(head);
  const bool universal =
      std::any_of(lines.begin(), lines.end(), [](std::string_view line) { return stripped(line) == "-1"; });
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
