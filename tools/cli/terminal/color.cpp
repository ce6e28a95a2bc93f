#include "cli/terminal/color.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace percuss::tools {
namespace {

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value != nullptr ? value : "";
}

// Colours `word` where two blanks precede it and a colon, two blanks or the line's end follow: a cell of a table.
void color_cell(std::string& line, std::string_view word, const char* color) {
  const std::size_t at = line.find("  " + std::string(word));
  if (at == std::string::npos) return;
  const std::size_t begin = at + 2, end = begin + word.size();
  const bool whole = end == line.size() || line[end] == ':' || line.compare(end, 2, "  ") == 0;
  if (whole) line.replace(begin, word.size(), color + std::string(word) + kPlain);
}

}  // namespace

bool wants_color(int descriptor) {
  return isatty(descriptor) == 1 && environment("NO_COLOR").empty() && environment("TERM") != "dumb";
}

std::string in_color(const std::string& text) {
  std::string out;
  bool warning = false;  // a warning continues in lines that begin with blanks
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string line = text.substr(from, end - from);
    warning = line.starts_with("! ") || (warning && line.starts_with("  "));
    if (warning) {
      line = kYellow + line + kPlain;
    } else {
      color_cell(line, "rejected", kRed);
      color_cell(line, "ok", kGreen);
    }
    out += line;
    if (end < text.size()) out += '\n';
    from = end + 1;
  }
  return out;
}

}  // namespace percuss::tools
