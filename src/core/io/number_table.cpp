#include "core/io/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_text.hpp"
#include "core/io/input_file.hpp"
#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

constexpr std::uint64_t kMaxTable_bytes = std::uint64_t{16} << 20U;
constexpr std::size_t kMaxCell = 40;  // shown in messages

bool are_names(const std::vector<std::string_view>& cells, bool decimal_comma) {
  return std::none_of(cells.begin(), cells.end(), [&](std::string_view cell) {
    const NumberProblem problem = parse_number(cell, decimal_comma).problem;
    return problem == NumberProblem::none || problem == NumberProblem::not_finite;
  });
}

NumberTableRow row_of(const std::vector<std::string_view>& cells, const std::string& place, const CsvDialect& dialect,
                      const NumberTableSpec& wanted, std::size_t columns) {
  if (cells.size() != columns)
    throw InputError(fmt::format("{} numbers wanted, {} found", columns, cells.size()), place, wanted.remedy);
  NumberTableRow row{.place = place, .values = {}};
  row.values.reserve(cells.size());
  for (const std::string_view cell : cells) {
    const ParsedNumber number = parse_number(cell, dialect.decimal_comma);
    if (number.problem != NumberProblem::none) {
      throw InputError(fmt::format("'{}' is {}", one_line(to_utf8(trimmed(cell)), kMaxCell), describe(number.problem)),
                       place, wanted.remedy);
    }
    row.values.push_back(number.value);
  }
  return row;
}

}  // namespace

NumberTable parse_named_number_table(std::string_view text, const std::string& where, const NumberTableSpec& wanted) {
  const char line_end = find_line_end(text);
  const CsvDialect dialect = find_dialect(probe_lines(text, line_end), line_end);
  const std::size_t most = std::max(wanted.columns, wanted.max_columns);
  std::size_t columns = wanted.columns;
  NumberTable table;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text, line_end);
    if (is_skipped(line, dialect)) continue;
    const auto cells = split_cells(line, dialect, most + 1);
    if (table.rows.empty() && are_names(cells, dialect.decimal_comma)) {
      std::vector<std::string>& names = table.headers.emplace_back();
      for (const std::string_view cell : cells) names.push_back(to_utf8(trimmed(cell)));
      continue;
    }
    const std::string place = fmt::format("{}: line {}", where, number);
    if (table.rows.size() == wanted.max_rows)
      throw InputError(fmt::format("more than {} lines", wanted.max_rows), place, wanted.remedy);
    if (table.rows.empty()) columns = std::clamp(cells.size(), wanted.columns, most);
    table.rows.push_back(row_of(cells, place, dialect, wanted, columns));
  }
  if (table.rows.empty()) throw InputError("no numbers", where, wanted.remedy);
  return table;
}

NumberTable read_named_number_table(const std::string& path, const NumberTableSpec& wanted) {
  const FileBytes bytes = read_input(path, kMaxTable_bytes);
  return parse_named_number_table(bytes.view(), input_name(path), wanted);
}

std::vector<NumberTableRow> parse_number_table(std::string_view text, const std::string& where,
                                               const NumberTableSpec& wanted) {
  return parse_named_number_table(text, where, wanted).rows;
}

}  // namespace core
}  // namespace percuss
