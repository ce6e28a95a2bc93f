#include "core/io/csv_dialect.hpp"

#include <algorithm>
#include <cstring>

#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_leading_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

bool take_blank_separated(std::string_view& line, std::string_view& cell) {
  line = without_leading_blanks(line);
  if (line.empty() || line.front() == '\r') return false;
  std::size_t end = 0;
  while (end < line.size() && !is_blank(line[end]) && line[end] != '\r') ++end;
  cell = line.substr(0, end);
  line.remove_prefix(end);
  return true;
}

// The end of the first cell of `line`: the first delimiter outside quotes.
std::size_t cell_end(std::string_view line, const CsvDialect& dialect) {
  const auto start = line.find_first_not_of(' ');
  if (start == std::string_view::npos || line[start] != '"') return std::min(line.find(dialect.delimiter), line.size());
  bool inside = false;
  for (std::size_t i = start; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;
    if (line[i] == dialect.delimiter && !inside) return i;
  }
  return line.size();
}

bool in_most(const std::vector<std::string_view>& lines, char wanted) {
  const auto count = std::count_if(lines.begin(), lines.end(), [&](std::string_view line) {
    bool inside = false;
    return std::any_of(line.begin(), line.end(), [&](char c) {
      if (c == '"') inside = !inside;
      return c == wanted && !inside;
    });
  });
  return 2 * static_cast<std::size_t>(count) > lines.size();
}

// Only numbers such as "0,25 -1,5e3 7": at least two, one or more with a decimal comma, none with a point.
bool is_comma_decimals(std::string_view line) {
  std::size_t words = 0, with_comma = 0;
  for (std::string_view cell; take_blank_separated(line, cell); ++words) {
    if (std::count(cell.begin(), cell.end(), ',') > 1 || parse_number(cell, true).problem != NumberProblem::none)
      return false;
    const auto comma = cell.find(',');
    if (comma == std::string_view::npos) continue;
    if (comma == 0 || comma + 1 == cell.size()) return false;
    ++with_comma;
  }
  return words > 1 && with_comma > 0;
}

bool has_comma_in_number(std::string_view line, const CsvDialect& dialect) {
  const auto cells = split_cells(line, dialect);
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return cell.find(',') != std::string_view::npos && parse_number(cell, true).problem == NumberProblem::none;
  });
}

std::vector<std::string_view> used_cells(std::string_view line, const CsvDialect& dialect) {
  auto cells = split_cells(line, dialect);
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

// The number of names in the last line before the numbers, and the lines of numbers among the first 64 lines.
struct Beginning {
  std::size_t names = 0;
  std::vector<std::string_view> numbers;
};

Beginning beginning_of(std::string_view text, const CsvDialect& dialect) {
  constexpr int kMaxLines = 64;
  Beginning out;
  for (int n = 0; n < kMaxLines && !text.empty(); ++n) {
    const std::string_view line = take_line(text, dialect.line_end);
    if (is_skipped(line, dialect)) continue;
    const auto cells = used_cells(line, dialect);
    const bool names = std::none_of(cells.begin(), cells.end(), [](std::string_view cell) {
      return parse_number(cell, false).problem == NumberProblem::none;
    });
    if (names && out.numbers.empty()) out.names = cells.size();
    if (!names) out.numbers.push_back(line);
  }
  return out;
}

// "05": probably the digits after a decimal comma, hardly ever a whole number.
bool is_zero_padded(std::string_view cell) {
  return cell.size() > 1 && cell[0] == '0' && cell.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::string_view take_line(std::string_view& rest, char line_end) {
  if (rest.empty()) return {};
  const auto* end = static_cast<const char*>(std::memchr(rest.data(), line_end, rest.size()));
  const std::size_t length = end == nullptr ? rest.size() : static_cast<std::size_t>(end - rest.data());
  std::string_view line = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

bool take_cell(std::string_view& line, const CsvDialect& dialect, std::string_view& cell) {
  if (dialect.delimiter == ' ') return take_blank_separated(line, cell);
  if (line.data() == nullptr) return false;
  const std::size_t end = cell_end(line, dialect);
  cell = line.substr(0, end);
  line = end < line.size() ? line.substr(end + 1) : std::string_view{};  // no data pointer after the last cell
  return true;
}

std::vector<std::string_view> split_cells(std::string_view line, const CsvDialect& dialect, std::size_t limit) {
  std::vector<std::string_view> cells;
  for (std::string_view cell; cells.size() < limit && take_cell(line, dialect, cell);) cells.push_back(trimmed(cell));
  return cells;
}

bool is_skipped(std::string_view line, const CsvDialect& dialect) {
  for (const char c : line) {
    if (c == '#' || c == '%') return true;
    if (!is_blank(c) && c != '\r' && c != '"' && c != dialect.delimiter) return false;
  }
  return true;
}

char find_line_end(std::string_view text) {
  const bool old_mac = text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
  return old_mac ? '\r' : '\n';
}

std::vector<std::string_view> probe_lines(std::string_view text, char line_end) {
  constexpr std::size_t kMax = 64;
  std::vector<std::string_view> lines;
  std::size_t last_end = 0;  // of the last line that is not skipped
  while (!text.empty() && lines.size() < kMax && (lines.empty() || text.size() > last_end - last_end / 8)) {
    text.remove_suffix(text.back() == line_end ? 1 : 0);
    const auto before = text.rfind(line_end);
    const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
    std::string_view line = text.substr(start);
    if (!is_skipped(line, {.delimiter = ','}) && !is_skipped(line, {.delimiter = ';'})) {
      if (lines.empty()) last_end = text.size();
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      lines.push_back(line);
    }
    text.remove_suffix(text.size() - start);
  }
  return lines;
}

CsvDialect find_dialect(const std::vector<std::string_view>& probes, char line_end) {
  CsvDialect dialect{.delimiter = ' ', .line_end = line_end};
  if (in_most(probes, ';')) {
    dialect.delimiter = ';';
  } else if (in_most(probes, '\t')) {
    dialect.delimiter = '\t';
  } else if (in_most(probes, ',') && !std::all_of(probes.begin(), probes.end(), is_comma_decimals)) {
    dialect.delimiter = ',';
  }
  const auto any = [&](auto&& test) { return std::any_of(probes.begin(), probes.end(), test); };
  dialect.quoted = any([](std::string_view line) { return line.find('"') != std::string_view::npos; });
  dialect.decimal_comma = any([&](std::string_view line) { return has_comma_in_number(line, dialect); });
  return dialect;
}

bool has_two_kinds_of_comma(std::string_view text, const std::vector<std::string_view>& probes,
                            const CsvDialect& dialect) {
  if (dialect.delimiter != ',' || dialect.decimal_comma) return false;
  auto [names, lines] = beginning_of(text, dialect);
  lines.insert(lines.end(), probes.begin(), probes.end());
  const auto more = std::count_if(probes.begin(), probes.end(), [&, names = names](std::string_view line) {
    return used_cells(line, dialect).size() > names;
  });
  std::size_t twice = 0, least = 0, most = 0;
  bool padded = false;
  for (const std::string_view line : lines) {
    if (line.find('.') != std::string_view::npos) return false;
    const auto cells = used_cells(line, dialect);
    if (cells.size() == 2 * names) ++twice;
    least = least == 0 ? cells.size() : std::min(least, cells.size());
    most = std::max(most, cells.size());
    padded = padded || std::any_of(cells.begin(), cells.end(), is_zero_padded);
  }
  const bool uneven = padded || least != most || twice == lines.size();
  return names > 1 && 2 * static_cast<std::size_t>(more) > probes.size() && most <= 2 * names && uneven;
}

std::vector<std::size_t> find_number_columns(const std::vector<std::string_view>& probes, const CsvDialect& dialect) {
  std::vector<std::size_t> numbers;
  for (const auto line : probes) {
    const auto cells = split_cells(line, dialect);
    numbers.resize(std::max(numbers.size(), cells.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto problem = parse_number(cells[c], dialect.decimal_comma).problem;
      if (problem != NumberProblem::empty && problem != NumberProblem::not_a_number) ++numbers[c];
    }
  }
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    if (2 * numbers[c] >= probes.size() && numbers[c] > 0) columns.push_back(c);
  }
  return columns;
}

}  // namespace core
}  // namespace percuss
