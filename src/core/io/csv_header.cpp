#include "core/io/csv_header.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/io/stated_rate.hpp"
#include "core/units.hpp"

namespace percuss {
inline namespace core {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::string_view kRemedy = "save it as text with one line per sample";

struct HeaderLine {
  std::string_view text;
  bool comment = false;
};

bool is_number(std::string_view cell, const CsvDialect& dialect) {
  const auto problem = parse_number(cell, dialect.decimal_comma).problem;
  return problem != NumberProblem::empty && problem != NumberProblem::not_a_number;
}

// Whether all columns of numbers hold a number or nothing, and at least half hold a number. A gap must not turn the
// first line of data into a header.
bool looks_like_data(std::string_view line, const CsvDialect& dialect, const std::vector<std::size_t>& columns) {
  const Cells cells = split_cells(line, dialect, columns.back() + 1);
  std::size_t numbers = 0;
  for (const auto c : columns) {
    if (c >= cells.size() || cells[c].empty()) continue;
    if (!is_number(cells[c], dialect)) return false;
    ++numbers;
  }
  return 2 * numbers >= columns.size();
}

// Where the first column is text, a header line such as "Range,5,5" looks like data. Four lines in a row must then look
// like data.
bool data_starts_here(std::string_view rest, const CsvDialect& dialect, const std::vector<std::size_t>& columns) {
  const int wanted = columns.front() == 0 ? 1 : 4;
  for (int seen = 0; seen < wanted && !rest.empty();) {
    const auto line = take_line(rest, dialect.line_end);
    if (is_skipped(line, dialect)) continue;
    if (!looks_like_data(line, dialect, columns)) return false;
    ++seen;
  }
  return true;
}

std::vector<HeaderLine> take_header_lines(std::string_view text, const CsvDialect& dialect,
                                          const std::vector<std::size_t>& columns, CsvHeader& header,
                                          const std::string& file) {
  constexpr std::size_t kMaxLines = 10000;
  std::vector<HeaderLine> lines;
  std::string_view rest = text;
  while (!rest.empty() && header.lines < kMaxLines) {
    std::string_view after = rest;
    std::string_view line = take_line(after, dialect.line_end);
    const bool skipped = is_skipped(line, dialect);
    if (!skipped && data_starts_here(rest, dialect, columns)) {
      header.data_start = text.size() - rest.size();
      return lines;
    }
    rest = after;
    ++header.lines;
    const bool comment = skipped && line.find_first_of("#%") != std::string_view::npos;
    if (comment) line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
    if (!skipped || comment) lines.push_back({line, comment});
  }
  throw NoNumbers("no lines of numbers after the header", file, kRemedy);
}

// Cells of a header line in a file with blanks as delimiter. The names may contain single blanks: "Time (s)  Force
// (N)".
Cells split_blank_separated(std::string_view line, std::size_t wanted) {
  Cells wide;
  while (!line.empty()) {
    const auto gap = std::min({line.find("  "), line.find('\t'), line.size()});
    if (const auto cell = trimmed(line.substr(0, gap)); !cell.empty()) wide.push_back(cell);
    line.remove_prefix(gap);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  if (wide.size() == wanted || wide.empty()) return wide;
  const std::string_view whole(wide.front().data(),
                               static_cast<std::size_t>(wide.back().data() - wide.front().data()) + wide.back().size());
  Cells cells;
  for (const auto cell : split_cells(whole, {.delimiter = ' '})) {
    const bool unit = !cells.empty() && (cell.starts_with('(') || cell.starts_with('['));
    if (unit) {
      cells.back() = {cells.back().data(), static_cast<std::size_t>(cell.data() - cells.back().data()) + cell.size()};
    } else {
      cells.push_back(cell);
    }
  }
  return cells;
}

Cells header_cells(std::string_view line, const CsvDialect& dialect, std::size_t columns) {
  return dialect.delimiter == ' ' ? split_blank_separated(line, columns) : split_cells(line, dialect);
}

bool is_name_row(const Cells& cells, const CsvDialect& dialect, const std::vector<std::size_t>& columns) {
  return std::all_of(columns.begin(), columns.end(), [&](std::size_t c) {
    if (c == 0 && columns.size() > 1) return !cells.empty() && !is_number(cells[0], dialect);
    return c < cells.size() && !cells[c].empty() && !is_number(cells[c], dialect);
  });
}

// "g/N", "(m/s^2)/N", "dB", "dB re 1 g/N".
bool is_frf_unit(std::string_view cell) {
  const std::string lower = lower_case(to_utf8(cell));
  if (lower.starts_with("db")) return true;
  const auto known = [](std::string text) {
    std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == '[' || c == ']'; });
    if (text.ends_with("/s") && !parse_unit(text)) text.resize(text.size() - 2);  // velocities
    return parse_unit(text).has_value();
  };
  const std::string text = to_utf8(cell);
  const std::size_t slash = text.rfind('/');
  return slash != std::string::npos && known(text.substr(0, slash)) && known(text.substr(slash + 1));
}

// Every column except the first has a unit or is empty, and at least one has a unit. The first cell often is "Unit".
bool is_unit_row(const Cells& cells, const std::vector<std::size_t>& columns) {
  std::size_t units = 0;
  for (const auto c : columns) {
    if (c >= cells.size() || cells[c].empty() || cells[c] == "-") continue;
    if (parse_unit(to_utf8(cells[c])) || is_frf_unit(cells[c])) {
      ++units;
    } else if (c != 0) {
      return false;
    }
  }
  return units > 0;
}

// Throws InputError where the column names show an FRF or a spectrum.
void refuse_frf(const std::vector<HeaderLine>& lines, const CsvDialect& dialect, std::size_t columns,
                const std::string& file) {
  for (const auto& line : lines) {
    const Cells cells = header_cells(line.text, dialect, columns);
    if (cells.size() < 2 || lower_case(cells.front()).substr(0, 4) != "freq") continue;
    const auto has = [&](std::string_view word) {
      return std::any_of(cells.begin() + 1, cells.end(),
                         [&](std::string_view cell) { return lower_case(cell).find(word) != std::string::npos; });
    };
    const bool frf = has("real") || has("imag") || has("phase") || has("mag") || has("frf");
    if (!frf && cells.size() < columns) continue;
    std::string names;
    for (const auto cell : cells) names += (names.empty() || cell.empty() ? "" : ", ") + lower_case(cell);
    const bool density = has("psd") || has("pxx") || has("densit") || has("/hz");
    const char* const what = frf ? "an FRF" : density ? "a power spectral density (PSD)" : "a spectrum";
    throw InputError(to_utf8(names) + ": this is " + what + ", not a time record", file,
                     "give the time signals it was made from");
  }
}

std::optional<Cells> last_row(const std::vector<HeaderLine>& lines, const CsvDialect& dialect, std::size_t columns,
                              const auto& fits) {
  for (const bool comment : {false, true}) {
    for (std::size_t i = lines.size(); i-- > 0;) {
      if (lines[i].comment != comment) continue;
      if (Cells cells = header_cells(lines[i].text, dialect, columns); fits(cells)) return cells;
    }
  }
  return std::nullopt;
}

void fill_columns(CsvHeader& header, const std::optional<Cells>& names, const std::optional<Cells>& units,
                  const std::vector<std::size_t>& number_columns) {
  const std::size_t count = std::max(names ? names->size() : 0, number_columns.back() + 1);
  for (std::size_t c = 0; c < count; ++c) {
    const bool numbers = std::binary_search(number_columns.begin(), number_columns.end(), c);
    const bool named = names && c < names->size() && !(*names)[c].empty();
    if (!numbers && !named) continue;
    CsvColumn column{.index = c, .has_numbers = numbers};
    column.name = named ? to_utf8((*names)[c]) : "column " + std::to_string(c + 1);
    auto [base, unit] = named ? split_name(column.name) : NameAndUnit{};
    column.base = std::move(base);
    column.unit = std::move(unit);
    // The first cell of the row of units may be "Unit".
    const bool stated = units && c < units->size() && !(*units)[c].empty();
    if (stated && (c > 0 || parse_unit(to_utf8((*units)[c])))) column.unit = to_utf8((*units)[c]);
    header.columns.push_back(std::move(column));
  }
}

}  // namespace

CsvHeader read_csv_header(std::string_view text, const CsvDialect& dialect,
                          const std::vector<std::size_t>& number_columns, const std::string& file, CsvContent content) {
  if (number_columns.empty()) throw NoNumbers("no lines of numbers found", file, kRemedy);
  CsvHeader header;
  const auto lines = take_header_lines(text, dialect, number_columns, header, file);
  const std::size_t count = number_columns.back() + 1;
  if (content == CsvContent::time_record) refuse_frf(lines, dialect, count, file);
  const auto is_units = [&](const Cells& cells) { return is_unit_row(cells, number_columns); };
  const auto is_names = [&](const Cells& cells) {
    return is_name_row(cells, dialect, number_columns) && !is_units(cells);
  };
  const auto names = last_row(lines, dialect, count, is_names);
  header.named = names.has_value();
  header.width = names ? names->size() : 0;
  fill_columns(header, names, last_row(lines, dialect, count, is_units), number_columns);
  for (const auto& line : lines) {
    if (const auto rate = stated_rate_Hz(line.text, dialect)) {
      header.fs_Hz = rate;
      header.fs_line = one_line(to_utf8(line.text), 60);
    }
  }
  return header;
}

NameAndUnit split_name(std::string_view name) {
  const std::string_view text = trimmed(name);
  if (!text.empty() && (text.back() == ')' || text.back() == ']')) {
    const auto open = text.rfind(text.back() == ')' ? " (" : " [");
    const auto at = open != std::string_view::npos ? open + 1 : text.find(text.back() == ')' ? '(' : '[');
    if (at != std::string_view::npos) {
      return {std::string(trimmed(text.substr(0, at))),
              std::string(trimmed(text.substr(at + 1, text.size() - at - 2)))};
    }
  }
  // The longest suffix that is a unit: "m_s2" of "acc0_m_s2", not "s2".
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    static constexpr std::string_view kSeparators = "_ /:,-";
    if (kSeparators.find(text[i]) == std::string_view::npos) continue;
    const auto ending = text.substr(i + 1);
    if (!parse_unit(ending)) continue;
    std::string unit(ending);
    std::replace(unit.begin(), unit.end(), '_', '/');
    return {std::string(trimmed(text.substr(0, i))), unit};
  }
  return {std::string(text), {}};
}

}  // namespace core
}  // namespace percuss
