#include "acquire/formats/text/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kBlock_lines = 4096;
constexpr std::size_t kMaxLine_bytes = std::size_t{1} << 20U;

std::size_t count_cells(std::string_view line, const CsvDialect& dialect) {
  if (dialect.delimiter != ' ' && !dialect.quoted) {
    return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), dialect.delimiter));
  }
  std::size_t count = 0;
  for (std::string_view cell; take_cell(line, dialect, cell);) ++count;
  return count;
}

// Empty cells at a line's end do not count: spreadsheets pad lines with delimiters.
std::size_t count_used_cells(std::string_view line, const CsvDialect& dialect) {
  auto cells = split_cells(line, dialect);
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells.size();
}

bool starts_as_number(std::string_view line) {
  return !line.empty() && ((line.front() >= '0' && line.front() <= '9') || line.front() == '-');
}

bool is_text(std::string_view cell, const CsvDialect& dialect) {
  return parse_number(cell, dialect.decimal_comma).problem == NumberProblem::not_a_number;
}

std::string_view cell_at(std::string_view line, std::size_t index, const CsvDialect& dialect) {
  std::string_view cell;
  for (std::size_t c = 0; c <= index; ++c) {
    if (!take_cell(line, dialect, cell)) return {};
  }
  return cell;
}

// Fast path: from_chars at the cell's start. Unusual numbers take the general parser.
ParsedNumber parse_cell(std::string_view line, std::size_t index, const CsvDialect& dialect) {
  if (!dialect.quoted && !dialect.decimal_comma && dialect.delimiter != ' ') {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t c = 0; c < index && at != end; ++c) {
      at = std::find(at, end, dialect.delimiter);
      if (at != end) ++at;
    }
    ParsedNumber number;
    const auto [stop, error] = std::from_chars(at, end, number.value);
    if (error == std::errc{} && (stop == end || *stop == dialect.delimiter) && std::isfinite(number.value))
      return number;
  }
  return parse_number(cell_at(line, index, dialect), dialect.decimal_comma);
}

}  // namespace

CsvTable::CsvTable(FileBytes bytes, CsvDialect dialect, CsvHeader header,
                   const std::vector<std::size_t>& number_columns)
    : bytes_(std::move(bytes)), dialect_(dialect), header_(std::move(header)) {
  assert(!number_columns.empty());
  find_header_lines(number_columns);
  // A line may have as many cells as the header or the first line of data, whichever has more: text may follow the
  // numbers.
  std::string_view rest = data();
  const std::size_t first = count_used_cells(take_line(rest, dialect_.line_end), dialect_);
  const std::size_t most = std::max({number_columns.back() + 1, header_.width, first});
  count_lines(number_columns.back() + 1, most);
}

void CsvTable::find_header_lines(const std::vector<std::size_t>& number_columns) {
  constexpr std::ptrdiff_t kMaxLines = 64;  // each is compared with lines of data; names and units are the last ones
  std::string_view rest = without_byte_order_mark(bytes_.view().substr(0, header_.data_start));
  while (!rest.empty()) {
    const std::string_view line = take_line(rest, dialect_.line_end);
    if (is_skipped(line, dialect_)) continue;
    const auto cells = split_cells(line, dialect_, number_columns.back() + 1);
    const bool text = std::any_of(number_columns.begin(), number_columns.end(),
                                  [&](std::size_t c) { return c < cells.size() && is_text(cells[c], dialect_); });
    if (text) header_lines_.push_back(line);
  }
  if (std::ssize(header_lines_) > kMaxLines)
    header_lines_.erase(header_lines_.begin(), header_lines_.end() - kMaxLines);
  header_like_number_ = std::any_of(header_lines_.begin(), header_lines_.end(), starts_as_number);
}

bool CsvTable::repeats_header(std::string_view line) const {
  return std::find(header_lines_.begin(), header_lines_.end(), line) != header_lines_.end();
}

// Fast path: a line that starts with a digit or a minus sign is data.
bool CsvTable::is_data(std::string_view line) const {
  if (starts_as_number(line) && !header_like_number_) return true;
  return !is_skipped(line, dialect_) && !repeats_header(line);
}

void CsvTable::count_lines(std::size_t fewest, std::size_t most) {
  std::string_view rest = data();
  const std::size_t size = rest.size();
  bool after_header = false;
  while (!rest.empty()) {
    const std::size_t start = size - rest.size();
    const std::string_view line = take_line(rest, dialect_.line_end);
    if (!is_data(line)) {
      after_header = after_header || repeats_header(line);
      continue;
    }
    if (after_header) lines_after_header_.push_back(lines_);
    after_header = false;
    if (lines_ % kBlock_lines == 0) block_start_.push_back(start);
    std::size_t cells = count_cells(line, dialect_);
    if (cells > most) cells = count_used_cells(line, dialect_);
    ++lines_;
    if (line.size() > kMaxLine_bytes) {
      throw InputError("a line of more than 1 MiB", place(lines_ - 1), "save one line per sample");
    }
    if (cells < fewest || cells > most) {
      const std::string found = fmt::format("{} column{} where {} are expected", cells, cells == 1 ? "" : "s",
                                            cells < fewest ? fewest : most);
      throw InputError(found, place(lines_ - 1), "complete or delete the line");
    }
  }
}

CsvTable::Column& CsvTable::column(std::size_t index) const {
  const std::lock_guard lock(columns_mutex_);
  auto& column = columns_[index];
  if (!column) column = std::make_unique<Column>(block_start_.size());
  return *column;
}

void CsvTable::parse_block(std::size_t index, std::size_t block, Block& into) const {
  const std::size_t first = block * kBlock_lines;
  const std::size_t count = std::min(kBlock_lines, lines_ - first);
  std::vector<double> numbers(count);
  std::string_view rest = data().substr(block_start_[block]);
  for (std::size_t i = 0; i < count;) {
    const std::string_view line = take_line(rest, dialect_.line_end);
    if (!is_data(line)) continue;
    const ParsedNumber number = parse_cell(line, index, dialect_);
    if (number.problem != NumberProblem::none) {
      const std::string text(trimmed(cell_at(line, index, dialect_)));
      throw InputError(number.problem == NumberProblem::empty
                           ? "an empty cell"
                           : fmt::format("\"{}\" is {}", one_line(to_utf8(text), 40), describe(number.problem)),
                       place(first + i, index), "fill the gap or cut the file before it");
    }
    numbers[i++] = number.value;
  }
  into.numbers = std::move(numbers);
}

void CsvTable::read(std::size_t index, std::size_t first, std::span<double> out) const {
  assert(first <= lines_ && out.size() <= lines_ - first);
  Column& blocks = column(index);
  while (!out.empty()) {
    const std::size_t b = first / kBlock_lines;
    const std::size_t offset = first % kBlock_lines;
    const std::size_t count = std::min(kBlock_lines - offset, out.size());
    const std::lock_guard lock(blocks[b].mutex);
    if (blocks[b].numbers.empty()) parse_block(index, b, blocks[b]);
    std::copy_n(blocks[b].numbers.data() + offset, count, out.begin());
    out = out.subspan(count);
    first += count;
  }
}

void CsvTable::for_each_cell(std::size_t index,
                             const std::function<void(std::size_t line, std::string_view cell)>& visit) const {
  std::string_view rest = data();
  for (std::size_t n = 0; !rest.empty();) {
    const std::string_view line = take_line(rest, dialect_.line_end);
    if (is_data(line)) visit(n++, cell_at(line, index, dialect_));
  }
}

std::string_view CsvTable::cell(std::size_t index, std::size_t line) const {
  std::string_view rest = data();
  for (std::size_t n = 0; !rest.empty();) {
    const std::string_view text = take_line(rest, dialect_.line_end);
    if (is_data(text) && n++ == line) return cell_at(text, index, dialect_);
  }
  return {};
}

std::string CsvTable::place(std::size_t line, std::optional<std::size_t> index) const {
  // Counts the file's lines only when a message needs the number.
  std::string_view rest = data();
  std::size_t file_line = header_.lines;
  for (std::size_t n = 0; !rest.empty();) {
    ++file_line;
    if (is_data(take_line(rest, dialect_.line_end)) && n++ == line) break;
  }
  std::string text = fmt::format("{}: line {}", input_name(bytes_.path), file_line);
  if (!index) return text;
  text += fmt::format(", column {}", *index + 1);
  for (const auto& column : header_.columns) {
    if (column.index == *index && header_.named) text += " (" + column.name + ")";
  }
  return text;
}

}  // namespace percuss::acquire
