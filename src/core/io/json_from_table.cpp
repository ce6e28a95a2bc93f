#include "core/io/json_from_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/csv_cell.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_text.hpp"
#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxStrictTable_bytes = std::size_t{16} << 20U;
constexpr std::size_t kMaxTableRows = 100'000;

// "# bat.length_in = 34" into document["bat"]["length_in"]; other comments are ignored.
void take_setting(std::string_view line, json& document, const std::string& place) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return;
  const std::string key = to_utf8(trimmed(line.substr(0, equals)));
  if (key.empty() || key.find(' ') != std::string::npos) return;
  const std::size_t dot = key.find('.');
  json& at = dot == std::string::npos ? document : document[key.substr(0, dot)];
  const std::string last = dot == std::string::npos ? key : key.substr(dot + 1);
  if ((!at.is_object() && !at.is_null()) || at.contains(last))
    throw InputError(fmt::format("\"{}\" is given twice", one_line(key, 60)), place, "keep one of them");
  at[last] = to_utf8(trimmed(line.substr(equals + 1)));
}

struct TableLine {
  std::size_t number = 0;
  std::string_view text;
};

std::vector<TableLine> table_lines(std::string_view text, json& document, const std::string& where) {
  std::vector<TableLine> lines;
  const char line_end = find_line_end(text);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(take_line(text, line_end));
    if (line.starts_with('#')) take_setting(line.substr(1), document, fmt::format("{}: line {}", where, number));
    if (!is_skipped(line, CsvDialect{})) lines.push_back({number, line});
    if (lines.size() > kMaxTableRows + 1) throw InputError("more than 100000 rows", where, "split the file");
  }
  return lines;
}

// All lines use the delimiter of the line of names.
CsvDialect table_dialect(std::string_view names) {
  for (const char delimiter : {';', '\t'}) {
    if (names.find(delimiter) != std::string_view::npos) return {.delimiter = delimiter, .decimal_comma = true};
  }
  return {};
}

}  // namespace

std::string json_from_table(const JsonText& input, StrictSource& source) {
  std::string_view text = without_byte_order_mark(input.text);
  if (text.size() > kMaxStrictTable_bytes) throw InputError("longer than 16 MiB", input.where, "split the file");
  if (text.find('\0') != std::string_view::npos)
    throw InputError("this is not text", input.where, input.remedy, input.options);
  json document = json::object();
  const auto lines = table_lines(text, document, input.where);
  if (lines.empty()) throw InputError("no line of column names", input.where, input.remedy, input.options);
  if (document.contains(source.rows))
    throw InputError("\"" + source.rows + "\" is set above the rows", input.where, "keep one of them");
  const CsvDialect dialect = table_dialect(lines.front().text);
  source.table = true;
  source.decimal_comma = dialect.decimal_comma;
  std::vector<std::string> names;
  for (const auto& cell : split_cells(lines.front().text, dialect)) names.push_back(to_utf8(cell));
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto twin = std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(c), names[c]);
    if (!names[c].empty() && twin != names.begin() + static_cast<std::ptrdiff_t>(c)) {
      throw InputError(fmt::format("two columns are called \"{}\"", one_line(names[c], 60)),
                       fmt::format("{}: line {}", input.where, lines.front().number), "keep one");
    }
  }
  json& list = document[source.rows] = json::array();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    json row = json::object();
    const auto cells = split_cells(lines[i].text, dialect);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].empty()) continue;
      if (c >= names.size() || names[c].empty()) {
        throw InputError(fmt::format("cell {} has no column name above it", c + 1),
                         fmt::format("{}: line {}", input.where, lines[i].number), "name every column");
      }
      row[names[c]] = to_utf8(text_of_csv_cell(cells[c]));
    }
    list.push_back(std::move(row));
    source.lines.push_back(lines[i].number);
  }
  return document.dump();
}

}  // namespace core
}  // namespace percuss
