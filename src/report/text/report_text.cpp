#include "report/text/report_text.hpp"

#include <sstream>

#include "core/error.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kIndent = 2, kMaxWarningBytes = 4000;

// Paragraphs of a page. The first paragraph is the verdict, unless a table stands above it; consecutive warnings form
// one list.
class Html {
 public:
  void paragraph(const std::string& line) {
    end_list();
    out_ += (first_ ? "<p class=\"verdict\">" : "<p>") + html_escape(line) + "</p>\n";
    first_ = false;
  }
  void lines(const std::string& text) {
    std::istringstream in(text);
    in.exceptions(std::ios::badbit);  // else a failed allocation would end the text
    for (std::string line; std::getline(in, line);) {
      const std::size_t begin = line.find_first_not_of(' ');
      if (begin != std::string::npos) paragraph(line.substr(begin));
    }
  }
  void warning(const std::string& message) {
    if (!in_list_) out_ += "<ul class=\"warnings\" aria-label=\"Warnings\">\n";
    in_list_ = true;
    out_ += "<li>" + html_escape(message) + "</li>\n";
  }
  void table(const TextTable& table) {
    end_list();
    first_ = false;
    out_ += table.html();
  }
  std::string text() {
    end_list();
    return out_;
  }

 private:
  void end_list() {
    if (in_list_) out_ += "</ul>\n";
    in_list_ = false;
  }

  std::string out_;
  bool first_ = true, in_list_ = false;
};

}  // namespace

ReportText::ReportText(std::string lines) { parts_.emplace_back(std::move(lines)); }

ReportText& ReportText::operator+=(const ReportText& more) {
  parts_.insert(parts_.end(), more.parts_.begin(), more.parts_.end());
  return *this;
}

ReportText& ReportText::operator+=(const std::string& lines) {
  parts_.emplace_back(lines);
  return *this;
}

ReportText& ReportText::operator+=(const TextTable& table) {
  parts_.emplace_back(table);
  return *this;
}

void ReportText::say(Message sentence) { parts_.emplace_back(Sentence{.message = std::move(sentence)}); }

void ReportText::warn(Message message) {
  message.text = one_line(message.text, kMaxWarningBytes);
  parts_.emplace_back(Sentence{.message = std::move(message), .warning = true});
}

std::string ReportText::text(std::size_t width, OptionWriter write, bool warnings) const {
  std::string out;
  bool left_out = false;
  for (const auto& part : parts_) {
    if (const auto* lines = std::get_if<std::string>(&part)) {
      out += *lines;
    } else if (const auto* sentence = std::get_if<Sentence>(&part)) {
      if (sentence->warning && !warnings) {
        left_out = true;
        continue;
      }
      const Message& message = sentence->message;
      const std::string words = write != nullptr ? message.written(write) : message.text;
      out += wrapped((sentence->warning ? "! " : "") + words, width, kIndent) + "\n";
    } else {
      out += std::get<TextTable>(part).text(width);
    }
  }
  while (left_out && out.ends_with("\n\n")) out.pop_back();
  return out;
}

std::string ReportText::html() const {
  Html html;
  for (const auto& part : parts_) {
    if (const auto* lines = std::get_if<std::string>(&part)) {
      html.lines(*lines);
    } else if (const auto* sentence = std::get_if<Sentence>(&part)) {
      sentence->warning ? html.warning(sentence->message.text) : html.paragraph(sentence->message.text);
    } else {
      html.table(std::get<TextTable>(part));
    }
  }
  return html.text();
}

ReportText operator+(ReportText a, const ReportText& b) {
  a += b;
  return a;
}

}  // namespace percuss::report
