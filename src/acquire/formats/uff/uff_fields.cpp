#include <algorithm>
#include <charconv>
#include <cmath>

#include "acquire/formats/uff/uff_file.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

// Fortran omits the letter where the exponent has three digits: "1.5-101".
std::string with_exponent_letter(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool sign = text[i] == '-' || text[i] == '+';
    const char before = i == 0 ? ' ' : text[i - 1];
    if (sign && ((before >= '0' && before <= '9') || before == '.')) out += 'e';
    out += text[i];
  }
  return out;
}

}  // namespace

std::string_view UffFields::take(std::size_t width) {
  const std::string_view cell = rest_.substr(0, width);
  rest_.remove_prefix(cell.size());
  return cell;
}

std::string UffFields::text(std::size_t width) {
  const std::string out = to_utf8(trimmed(take(width)));
  return out == "NONE" ? "" : out;
}

std::optional<std::int64_t> UffFields::integer(std::size_t width) {
  std::string_view cell = trimmed(take(width));
  if (cell.empty()) return 0;
  if (cell.front() == '+') cell.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

std::optional<double> UffFields::number(std::size_t width) {
  std::string_view cell = take(width);
  const auto first = cell.find_first_not_of(' ');
  if (first == std::string_view::npos) return 0;
  cell = cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error == std::errc{} && end == cell.data() + cell.size()) return value;
  ParsedNumber parsed = parse_number(cell, false);
  if (parsed.problem == NumberProblem::not_a_number) parsed = parse_number(with_exponent_letter(cell), false);
  if (parsed.problem == NumberProblem::not_finite) return std::nan("");
  if (parsed.problem != NumberProblem::none) return std::nullopt;
  return parsed.value;
}

std::string_view take_uff_line(std::string_view& rest) {
  const auto end = std::min(rest.find('\n'), rest.size());
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::optional<std::uint64_t> uff_data_bytes(std::string_view record7) {
  constexpr std::int64_t kMaxValues = std::int64_t{1} << 40U;
  UffFields fields(record7);
  const auto type = fields.integer(10), values = fields.integer(10), spacing = fields.integer(10);
  if (!type || !values || !spacing || *values < 0 || *values > kMaxValues) return std::nullopt;
  if (*type != 2 && *type != 4 && *type != 5 && *type != 6) return std::nullopt;
  const std::uint64_t number = *type == 2 || *type == 5 ? 4 : 8;
  const std::uint64_t parts = *type >= 5 ? 2 : 1;
  const std::uint64_t abscissa = *spacing == 0 ? 4 : 0;  // single precision for every ordinate
  return static_cast<std::uint64_t>(*values) * (abscissa + parts * number);
}

}  // namespace percuss::acquire
