#include "report/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <string_view>
#include <vector>

#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

// The last column is wrapped at the terminal's width if this leaves it kTightWrap characters or more. Otherwise it is
// kMinWrap wide, because lines that are too long are easier to read than a narrower column.
constexpr std::size_t kMinWrap = 24, kTightWrap = 14;
constexpr std::size_t kColumnGap = 2;
constexpr std::size_t kMaxNormalColumns = 9;  // of a table on a page: a wider one has smaller letters

std::string padded(const std::string& cell, std::size_t width, TextTable::Align align) {
  const std::string space(width - std::min(width, text_width(cell)), ' ');
  return align == TextTable::Align::left ? cell + space : space + cell;
}

void trim_right(std::string& line) {
  while (!line.empty() && line.back() == ' ') line.pop_back();
}

// Where the next column begins after these.
std::size_t end_of(const std::vector<std::size_t>& columns, const std::vector<std::size_t>& widths) {
  std::size_t end = 0;
  for (const std::size_t c : columns) end += widths[c] + kColumnGap;
  return end;
}

}  // namespace

std::size_t text_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

namespace {

// A number, or "±". A sign or an opening bracket may come before the number: "35.5", "(12.0".
bool is_number(std::string_view word) {
  if (word == "±") return true;
  const std::size_t digit = word.find_first_not_of("(+-");
  return digit != std::string_view::npos && word.find_first_not_of("0123456789.", digit) == std::string_view::npos;
}

// A unit of measurement or "±". Punctuation may follow it: "Hz,".
bool is_unit(std::string_view word) {
  constexpr std::array<std::string_view, 19> kUnits{"%",  "Hz", "kHz", "s",  "ms", "N", "g",   "kg",  "m",  "mm",
                                                    "in", "oz", "mph", "°F", "dB", "±", "m/s", "lbf", "GPa"};
  word = word.substr(0, word.find_last_not_of(".,;:)") + 1);
  return std::find(kUnits.begin(), kUnits.end(), word) != kUnits.end();
}

// The words of a text. A number and its unit or standard deviation form one word.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  in.exceptions(std::ios::badbit);  // else a failed allocation would end the text
  std::vector<std::string> words;
  bool after_number = false;
  for (std::string word; in >> word; after_number = is_number(word)) {
    if (after_number && (is_unit(word) || words.back().ends_with("±"))) {
      words.back() += ' ' + word;
    } else {
      words.push_back(word);
    }
  }
  return words;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t at = indent;
  for (const std::string& word : words_of(text)) {
    const std::size_t length = text_width(word);
    if (at > indent && at + 1 + length > width) {
      out += '\n' + std::string(indent, ' ');
      at = indent;
    } else if (at > indent) {
      out += ' ';
      ++at;
    }
    out += word;
    at += length;
  }
  return out;
}

std::string TextTable::text(std::size_t width) const {
  std::vector<std::size_t> widths;  // of the columns
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t most = text_width(columns_[c].head);
    for (const auto& row : rows_) most = std::max(most, text_width(row[c]));
    widths.push_back(most);
  }
  std::vector<std::size_t> keys(key_columns_);
  std::iota(keys.begin(), keys.end(), std::size_t{0});
  std::string out;
  std::vector<std::size_t> columns = keys;  // of the next part
  for (std::size_t c = key_columns_; c < columns_.size(); ++c) {
    const bool last = c + 1 == columns_.size();  // wrapped, so that it needs no part of its own
    if (key_columns_ > 0 && columns.size() > key_columns_ && !last && end_of(columns, widths) + widths[c] > width) {
      out += part(columns, widths, width) + '\n';
      columns = keys;
    }
    columns.push_back(c);
  }
  return out + part(columns, widths, width);
}

std::string TextTable::part(const std::vector<std::size_t>& columns, const std::vector<std::size_t>& widths,
                            std::size_t width) const {
  const bool wraps = columns.back() + 1 == columns_.size();
  const std::size_t before_last = end_of({columns.begin(), columns.end() - 1}, widths);
  const std::size_t limit = before_last + kTightWrap <= width ? width : before_last + kMinWrap;
  const auto line = [&](const auto& cell_of) {
    std::string text;
    for (const std::size_t c : columns) {
      if (c == columns.back() && wraps) {
        text += wrapped(cell_of(c), limit, before_last);
      } else {
        text += padded(cell_of(c), widths[c], columns_[c].align) + std::string(kColumnGap, ' ');
      }
    }
    trim_right(text);
    return text + '\n';
  };
  std::string out = line([&](std::size_t c) { return columns_[c].head; });
  for (const auto& row : rows_) out += line([&](std::size_t c) { return row[c]; });
  return out;
}

std::string TextTable::html() const {
  const auto wraps = [&](std::size_t c) {  // a cell too long for one line
    return std::any_of(rows_.begin(), rows_.end(), [&](const auto& row) { return text_width(row[c]) > kMinWrap; });
  };
  std::vector<std::string> kinds;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    kinds.emplace_back(columns_[c].align == Align::right ? " class=\"right\"" : wraps(c) ? " class=\"words\"" : "");
  const auto line = [&](const char* tag, const std::vector<std::string>& cells, bool in_result) {
    std::string out = in_result ? "<tr>" : "<tr class=\"excluded\">";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      out += fmt::format("<{0}{1}>{2}</{0}>", tag, kinds[c], html_escape(cells[c]));
    }
    return out + "</tr>\n";
  };
  std::vector<std::string> heads;
  for (const Column& column : columns_) heads.push_back(column.head);
  std::string out = columns_.size() > kMaxNormalColumns ? "<table class=\"wide\">\n<thead>" : "<table>\n<thead>";
  out += line("th", heads, true) + "</thead>\n<tbody>\n";
  for (std::size_t row = 0; row < rows_.size(); ++row) out += line("td", rows_[row], in_result_[row]);
  return out + "</tbody>\n</table>\n";
}

}  // namespace percuss::report
