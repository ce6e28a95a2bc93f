#include "core/io/thousands_separators.hpp"

#include <algorithm>
#include <cstddef>

namespace percuss {
inline namespace core {
namespace {

constexpr std::size_t kHeadLines = 64;
constexpr std::size_t kMinCells = 3;  // cells of each kind in a column: fewer may be chance
constexpr std::size_t kGroup = 3;     // digits after a thousands separator

std::size_t digits_at(std::string_view cell, std::size_t at) {
  const std::size_t end = cell.find_first_not_of("0123456789", at);
  return (end == std::string_view::npos ? cell.size() : end) - std::min(at, cell.size());
}

enum class Grouping { none, whole, possible, certain };

// Whether digits stand in groups of thousands. The comma of "5,040" may be a decimal mark instead; "1,005,040",
// "5,040.5" and "5'040" are certain. A number that begins with 0 has no groups.
Grouping grouping_of(std::string_view cell) {
  if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
  std::size_t at = digits_at(cell, 0);
  if (at == 0 || at > kGroup) return Grouping::none;
  if (at == cell.size()) return Grouping::whole;
  if (cell.front() == '0') return Grouping::none;
  const char separator = cell[at];
  if (std::string_view(",.' ").find(separator) == std::string_view::npos) return Grouping::none;
  std::size_t groups = 0;
  for (; at < cell.size() && cell[at] == separator; at += kGroup + 1, ++groups) {
    if (digits_at(cell, at + 1) != kGroup) return Grouping::none;
  }
  const bool mark = separator == ',' || separator == '.';
  if (at == cell.size()) return groups > 1 || !mark ? Grouping::certain : Grouping::possible;
  const char decimal = cell[at];
  const bool ends_in_decimals = (decimal == '.' || decimal == ',') && digits_at(cell, at + 1) == cell.size() - at - 1;
  return ends_in_decimals ? Grouping::certain : Grouping::none;
}

struct ColumnCells {
  std::size_t whole = 0, possible = 0, certain = 0, other = 0;
  std::string_view example;

  void add(std::string_view cell) {
    const Grouping grouping = grouping_of(cell);
    if (grouping == Grouping::whole) ++whole;
    if (grouping == Grouping::none) ++other;
    if (grouping == Grouping::possible) ++possible;
    if (grouping == Grouping::certain) ++certain;
    if (grouping == Grouping::certain || (grouping == Grouping::possible && example.empty())) example = cell;
  }
  // `quoted_commas`: the numbers are quoted because the comma also separates cells. Decimals are rarely written so.
  bool holds_separators(bool quoted_commas) const {
    return certain >= kMinCells || (other == 0 && possible >= kMinCells && (whole >= kMinCells || quoted_commas));
  }
};

}  // namespace

std::string cell_with_thousands_separators(std::string_view text, const std::vector<std::string_view>& probes,
                                           const CsvDialect& dialect) {
  std::vector<std::string_view> lines = probes;
  const char* const end = probes.empty() ? nullptr : probes.back().data();  // the first of the probes in the text
  for (std::size_t n = 0; n < kHeadLines && !text.empty() && text.data() != end; ++n) {
    const std::string_view line = take_line(text, dialect.line_end);
    if (!is_skipped(line, dialect)) lines.push_back(line);
  }
  std::vector<ColumnCells> columns;
  for (const std::string_view line : lines) {
    const auto cells = split_cells(line, dialect);
    columns.resize(std::max(columns.size(), cells.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      // Names of columns are no numbers.
      if (cells[c].find_first_of("0123456789") == 0 || cells[c].find_first_of("+-") == 0) columns[c].add(cells[c]);
    }
  }
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const ColumnCells& column) {
    return column.holds_separators(dialect.delimiter == ',' && column.example.find(',') != std::string_view::npos);
  });
  return found == columns.end() ? "" : std::string(found->example);
}

}  // namespace core
}  // namespace percuss
