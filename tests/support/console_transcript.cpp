#include "support/console_transcript.hpp"

#include <cctype>
#include <cstdlib>
#include <sstream>

#include "core/sanitized.hpp"

namespace percuss::test {
namespace {

constexpr long long kLastDigit = 1;        // units of the last shown digit
constexpr long long kLastDigitBeside = 2;  // next to a ±

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A number without its sign: digits, decimals, exponent.
struct ShownNumber {
  std::string digits;  // without the decimal point
  std::size_t decimals = 0;
  bool point = false;
  std::string exponent;  // as written, "e-05"
  std::size_t length = 0;
};

ShownNumber number_at(std::string_view text) {
  ShownNumber number;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const bool point = text[i] == '.' && !number.point && i + 1 < text.size() && is_digit(text[i + 1]);
    if (!is_digit(text[i]) && !point) break;
    if (point) {
      number.point = true;
    } else {
      number.digits += text[i];
      number.decimals += number.point ? 1 : 0;
    }
  }
  number.length = i;
  std::size_t j = i + 1;
  if (i >= text.size() || text[i] != 'e') return number;
  if (j < text.size() && (text[j] == '-' || text[j] == '+')) ++j;
  const std::size_t first = j;
  while (j < text.size() && is_digit(text[j])) ++j;
  if (j == first) return number;
  number.exponent = text.substr(i, j - i);
  number.length = j;
  return number;
}

bool same_number(const ShownNumber& a, const ShownNumber& b, long long units) {
  if (a.point != b.point || a.decimals != b.decimals || a.exponent != b.exponent) return false;
  if (!a.point && a.exponent.empty()) return a.digits == b.digits;
  return std::llabs(std::atoll(a.digits.c_str()) - std::atoll(b.digits.c_str())) <= units;
}

bool beside_deviation(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::string_view before = "± ", after = " ±";
  return text.substr(0, begin).ends_with(before) || text.substr(end).starts_with(after);
}

using Lines = std::vector<std::string>;

bool match(Lines::const_iterator shown, Lines::const_iterator shown_end, Lines::const_iterator printed,
           Lines::const_iterator printed_end, LastDigits digits) {
  for (; shown != shown_end; ++shown, ++printed) {
    if (*shown == "...") {
      for (auto rest = printed;; ++rest) {
        if (match(shown + 1, shown_end, rest, printed_end, digits)) return true;
        if (rest == printed_end) return false;
      }
    }
    if (printed == printed_end || !same_line(*shown, *printed, digits)) return false;
  }
  return printed == printed_end;
}

}  // namespace

std::vector<TranscriptCommand> transcript_commands(const std::string& page) {
  std::vector<TranscriptCommand> commands;
  std::istringstream lines(page);
  bool inside = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && line.starts_with("$ ")) {
      commands.push_back({.script = line.substr(2), .expected = {}, .line = number});
    } else if (inside && line.starts_with("> ") && !commands.empty() && commands.back().expected.empty()) {
      commands.back().script += "\n" + line.substr(2);
    } else if (inside && !commands.empty()) {
      commands.back().expected.push_back(line);
    }
  }
  return commands;
}

LastDigits last_digits_of_this_build() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  return kSanitized ? LastDigits::rounded : LastDigits::equal;
#else
  return LastDigits::rounded;
#endif
}

bool same_line(std::string_view shown, std::string_view printed, LastDigits digits) {
  if (digits == LastDigits::equal) return shown == printed;
  std::size_t i = 0, j = 0;
  while (i < shown.size() && j < printed.size()) {
    if (!is_digit(shown[i]) || !is_digit(printed[j])) {
      if (shown[i++] != printed[j++]) return false;
      continue;
    }
    const ShownNumber a = number_at(shown.substr(i)), b = number_at(printed.substr(j));
    const bool beside = beside_deviation(shown, i, i + a.length);
    if (!same_number(a, b, beside ? kLastDigitBeside : kLastDigit)) return false;
    i += a.length;
    j += b.length;
  }
  return i == shown.size() && j == printed.size();
}

bool matches_transcript(const Lines& shown, const Lines& printed, LastDigits digits) {
  return match(shown.begin(), shown.end(), printed.begin(), printed.end(), digits);
}

}  // namespace percuss::test
