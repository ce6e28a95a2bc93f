#include "core/io/parse_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace percuss {
inline namespace core {
namespace {

constexpr long long kHugeExponent = 1LL << 40;  // more than the digits of any text in memory can offset
constexpr std::size_t kMaxRewritten = 64;       // characters of a number with decimal comma or D exponent

bool is_padding(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

// from_chars reports "out of range" for numbers too large and too small. The power of ten of the first digit other than
// zero distinguishes them.
ParsedNumber out_of_range(std::string_view text) {
  const auto exponent_at = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, exponent_at);
  const auto point = std::min(mantissa.find('.'), mantissa.size());
  const auto first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  const auto power = static_cast<long long>(point) - static_cast<long long>(first);
  long long exponent = 0;
  if (exponent_at < text.size()) {
    std::string_view digits = text.substr(exponent_at + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error == std::errc::result_out_of_range) exponent = digits.front() == '-' ? -kHugeExponent : kHugeExponent;
  }
  if (power + exponent < 0) return {0, NumberProblem::none};
  return {0, NumberProblem::too_large};
}

ParsedNumber parse_plain(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return {0, NumberProblem::not_a_number};
  if (error == std::errc::result_out_of_range) return out_of_range(text);
  if (!std::isfinite(value)) return {0, NumberProblem::not_finite};
  return {value, NumberProblem::none};
}

// Replaces decimal comma by point and exponent letters by e: from_chars stops at D.
ParsedNumber parse_rewritten(std::string_view text, bool decimal_comma) {
  std::array<char, kMaxRewritten> plain{};
  if (text.size() > plain.size()) return {0, NumberProblem::not_a_number};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (decimal_comma && c == '.') return {0, NumberProblem::not_a_number};
    if (decimal_comma && c == ',') {
      plain.at(i) = '.';
    } else {
      plain.at(i) = (c == 'd' || c == 'D') && i > 0 ? 'e' : c;
    }
  }
  return parse_plain({plain.data(), text.size()});
}

bool says_not_finite(std::string_view text) {
  static constexpr std::array<std::string_view, 9> kWords = {"#NUM!",   "#N/A",    "#DIV/0!", "1.#INF", "-1.#IND",
                                                             "1.#QNAN", "-1.#INF", "1.#IND",  "INF"};
  return std::find(kWords.begin(), kWords.end(), text) != kWords.end();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto strip = [](std::string_view& t) {
    while (!t.empty() && is_padding(t.front())) t.remove_prefix(1);
    while (!t.empty() && is_padding(t.back())) t.remove_suffix(1);
  };
  strip(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
    strip(text);
  }
  return text;
}

ParsedNumber parse_number(std::string_view cell, bool decimal_comma) {
  std::string_view text = trimmed(cell);
  if (text.empty()) return {0, NumberProblem::empty};
  // from_chars rejects a leading '+'; "+-1" must stay an error.
  if (text.size() > 1 && text.front() == '+' && (is_digit(text[1]) || text[1] == '.' || text[1] == ','))
    text.remove_prefix(1);
  const bool rewrite = decimal_comma || text.find_first_of("dD") != std::string_view::npos;
  const ParsedNumber number = rewrite ? parse_rewritten(text, decimal_comma) : parse_plain(text);
  if (number.problem == NumberProblem::not_a_number && says_not_finite(text)) return {0, NumberProblem::not_finite};
  return number;
}

std::string_view describe(NumberProblem problem) {
  switch (problem) {
    case NumberProblem::none:
      return "a number";
    case NumberProblem::empty:
      return "empty";
    case NumberProblem::not_a_number:
      return "not a number";
    case NumberProblem::not_finite:
      return "not finite";
    case NumberProblem::too_large:
      return "too large";
  }
  return {};
}

int decimals_of(std::string_view cell, bool decimal_comma) {
  const std::string_view text = trimmed(cell);
  const auto exponent_at = std::min(text.find_first_of("eEdD"), text.size());
  int exponent = 0;
  if (exponent_at < text.size()) {
    std::string_view digits = text.substr(exponent_at + 1);
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    exponent = std::clamp(exponent, -400, 400);
  }
  const auto mark = text.substr(0, exponent_at).find(decimal_comma ? ',' : '.');
  const auto behind = mark == std::string_view::npos ? 0 : exponent_at - mark - 1;
  return static_cast<int>(std::min<std::size_t>(behind, 400)) - exponent;
}

}  // namespace core
}  // namespace percuss
