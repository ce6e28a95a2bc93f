#include "cli/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxLetters = 60;  // no option or command is longer
constexpr std::size_t kMinPrefix = 2;    // letters of a prefix

std::string normalised(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('-'), text.size()));
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// Optimal string alignment: Damerau's distance in which no part of the text changes twice.
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
  const std::string wanted = normalised(typed);
  if (wanted.empty() || wanted.size() > kMaxLetters) return std::nullopt;
  std::optional<std::string> best, completed;
  std::size_t fewest = SIZE_MAX, prefixed = 0;
  for (const std::string& one : known) {
    const std::string name = normalised(one);
    const std::size_t changes = distance(wanted, name);
    // At equal distance the same first letter decides, since first letters are seldom mistyped.
    const bool nearer = changes < fewest || (changes == fewest && name.front() == wanted.front() && best &&
                                             normalised(*best).front() != wanted.front());
    if (changes <= (std::max(wanted.size(), name.size()) + 1) / 3 && nearer) {
      fewest = changes;
      best = one;
    }
    if (wanted.size() >= kMinPrefix && name.starts_with(wanted)) {
      completed = one;
      ++prefixed;
    }
  }
  return prefixed == 1 ? completed : best;
}

}  // namespace percuss::tools
