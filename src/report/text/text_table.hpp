#pragma once
#include <string>
#include <vector>

namespace percuss::report {

/// A table of text for a terminal: columns as wide as their longest cell, two spaces between; the last column is
/// wrapped at `width`. Widths count characters, not bytes (UTF-8).
class TextTable {
 public:
  enum class Align { left, right };
  struct Column {
    std::string head;
    Align align = Align::left;
  };
  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
  /// `in_result`: false for values that no result contains. The page strikes them through.
  void add(std::vector<std::string> cells, bool in_result = true) {
    rows_.push_back(std::move(cells));
    in_result_.push_back(in_result);
  }
  /// Allows parts below each other where the table is wider than the terminal: each begins with the first `columns`
  /// columns and goes on with as many others as fit.
  void split_after(std::size_t columns) { key_columns_ = columns; }
  std::string text(std::size_t width) const;
  /// The table as an HTML element, its cells escaped.
  std::string html() const;

 private:
  std::string part(const std::vector<std::size_t>& columns, const std::vector<std::size_t>& widths,
                   std::size_t width) const;
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<bool> in_result_;  // per row
  std::size_t key_columns_ = 0;  // 0: never in parts
};

/// Number of characters of a UTF-8 text.
std::size_t text_width(const std::string& text);

/// `text` broken at spaces into lines of at most `width` characters, later lines indented. A number stays on one line
/// with its unit and its standard deviation.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace percuss::report
