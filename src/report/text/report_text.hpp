#pragma once
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// The text of a report in its order: lines, tables, sentences and warnings, for a terminal or for a page.
class ReportText {
 public:
  ReportText() = default;
  ReportText(std::string lines);  // NOLINT(google-explicit-constructor): lines alone are a report's text
  ReportText& operator+=(const ReportText& more);
  ReportText& operator+=(const std::string& lines);  // verbatim, each with its line end
  ReportText& operator+=(const TextTable& table);
  /// Adds a sentence, wrapped at the terminal's width with later lines indented.
  void say(Message sentence);
  /// Adds a warning: a sentence after an exclamation mark.
  void warn(Message message);

  /// For a terminal of `width` columns. `write` appends the options of sentences and warnings; nullptr leaves
  /// them out. `warnings` = false leaves out the warnings, and the blank lines before them at the end.
  std::string text(std::size_t width, OptionWriter write = nullptr, bool warnings = true) const;
  /// As elements of HTML: the first line as the verdict, if no table stands above it, then paragraphs, tables and
  /// warnings.
  std::string html() const;

 private:
  struct Sentence {
    Message message;
    bool warning = false;
  };
  std::vector<std::variant<std::string, Sentence, TextTable>> parts_;
};

ReportText operator+(ReportText a, const ReportText& b);

}  // namespace percuss::report
