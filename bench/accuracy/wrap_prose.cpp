#include "wrap_prose.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

namespace percuss::accuracy {
namespace {

// Characters of a UTF-8 text: all bytes but the continuation bytes.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// A word that Markdown would read as the beginning of a list, heading, quotation or table at the start of a line.
bool is_marker(const std::string& word) {
  if (word.find_first_not_of("-+*#>|") == std::string::npos) return true;
  return word.find_first_not_of("0123456789") == word.size() - 1 && (word.back() == '.' || word.back() == ')');
}

class Wrapper {
 public:
  explicit Wrapper(std::size_t width) : width_(width) {}

  void add_verbatim(const std::string& line) {
    end_paragraph();
    out_ += line + '\n';
  }
  void add_prose(const std::string& line) {
    if (line.starts_with("- ")) end_paragraph();
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      pending_ += (pending_.empty() ? "" : " ") + word;
      if (std::count(pending_.begin(), pending_.end(), '`') % 2 == 0) add_word(std::exchange(pending_, {}));
    }
  }
  std::string take() {
    end_paragraph();
    return std::move(out_);
  }

 private:
  void add_word(const std::string& word) {
    if (line_.empty()) {
      is_item_ = word == "-";
      line_ = word;
    } else if (width_of(line_) + 1 + width_of(word) <= width_ || is_marker(word)) {
      line_ += ' ' + word;
    } else {
      out_ += line_ + '\n';
      line_ = (is_item_ ? "  " : "") + word;
    }
  }
  void end_paragraph() {
    if (!pending_.empty()) add_word(std::exchange(pending_, {}));
    if (!line_.empty()) out_ += line_ + '\n';
    line_.clear();
  }

  std::size_t width_;
  bool is_item_ = false;
  std::string pending_;  // an open span of `code`, which stays on one line
  std::string line_, out_;
};

}  // namespace

std::string wrap_prose(const std::string& page, std::size_t width) {
  Wrapper wrapper(width);
  std::istringstream lines(page);
  bool in_code = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_fence = line.starts_with("```");
    if (is_fence) in_code = !in_code;
    const bool is_prose =
        !is_fence && !in_code && !line.empty() && std::string_view("|#!<").find(line[0]) == std::string_view::npos;
    if (is_prose) {
      wrapper.add_prose(line);
    } else {
      wrapper.add_verbatim(line);
    }
  }
  return wrapper.take();
}

}  // namespace percuss::accuracy
