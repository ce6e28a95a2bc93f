#pragma once
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "report/text/text_table.hpp"

namespace percuss::report {

/// What a report says, in its order: lines, tables, sentences and warnings. Told once, shown on a terminal or on a
/// page.
class ReportText {
 public:
  ReportText() = default;
  ReportText(std::string lines);  // NOLINT(google-explicit-constructor): a text of lines alone is a report's text
  ReportText& operator+=(const ReportText& more);
  ReportText& operator+=(const std::string& lines);  // as they stand, each with its line end
  ReportText& operator+=(const TextTable& table);
  /// A sentence that is broken where the terminal ends, later lines indented.
  void say(std::string sentence);
  /// The same after an exclamation mark.
  void warn(const std::string& message);

  /// For a terminal of `width` columns.
  std::string text(std::size_t width) const;
  /// As elements of HTML: the first line as the verdict, then paragraphs, tables and warnings.
  std::string html() const;

 private:
  struct Sentence {
    std::string text;
    bool warning = false;
  };
  std::vector<std::variant<std::string, Sentence, TextTable>> parts_;
};

ReportText operator+(ReportText a, const ReportText& b);

}  // namespace percuss::report
