#include "cli/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace percuss::tools {
namespace {

constexpr std::size_t kLongest = 60;  // what is longer is no name of ours
constexpr std::size_t kMinShown = 2;  // letters that a beginning must have

std::string bare(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('-'), text.size()));
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// Damerau's distance, no part of the text changed twice ("optimal string alignment").
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& known) {
  const std::string wanted = bare(typed);
  if (wanted.empty() || wanted.size() > kLongest) return std::nullopt;
  std::optional<std::string> best, begun;
  std::size_t least = SIZE_MAX, beginnings = 0;
  for (const std::string& one : known) {
    const std::string name = bare(one);
    const std::size_t changes = distance(wanted, name);
    // Of two that are as near, the one that begins alike: first letters are seldom mistyped.
    const bool nearer = changes < least || (changes == least && name.front() == wanted.front() && best &&
                                            bare(*best).front() != wanted.front());
    if (changes <= (std::max(wanted.size(), name.size()) + 1) / 3 && nearer) {
      least = changes;
      best = one;
    }
    if (wanted.size() >= kMinShown && name.starts_with(wanted)) {
      begun = one;
      ++beginnings;
    }
  }
  return beginnings == 1 ? begun : best;
}

}  // namespace percuss::tools
