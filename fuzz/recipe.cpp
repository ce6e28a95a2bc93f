#include "recipe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace percuss::fuzz {

bool RecipeLine::has(std::string_view option) const {
  return std::find(words.begin(), words.end(), option) != words.end();
}

std::vector<double> RecipeLine::numbers(std::size_t at) const {
  constexpr std::size_t kMaxNumbers = 64;
  std::vector<double> out;
  std::istringstream list(word(at));
  std::string item;
  while (std::getline(list, item, ',') && out.size() < kMaxNumbers) out.push_back(std::strtod(item.c_str(), nullptr));
  return out;
}

std::vector<std::size_t> RecipeLine::sizes(std::size_t at, std::size_t largest) const {
  std::vector<std::size_t> out;
  for (const double number : numbers(at)) {
    const bool usable = number >= 0 && number <= static_cast<double>(largest);
    out.push_back(usable ? static_cast<std::size_t>(number) : largest);
  }
  return out;
}

std::vector<RecipeLine> recipe_lines(std::string_view text) {
  constexpr std::size_t kMaxLines = 24;
  std::vector<RecipeLine> lines;
  std::istringstream in{std::string(text)};
  std::string line, word;
  while (lines.size() < kMaxLines && std::getline(in, line)) {
    RecipeLine& out = lines.emplace_back();
    for (std::istringstream words(line); words >> word;) out.words.push_back(word);
    if (out.words.empty()) lines.pop_back();
  }
  return lines;
}

std::vector<double> recipe_values(std::size_t count, bool with_nan) {
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    out[i] = i < 3 ? 50.0 * t : std::exp(-t / 20) * std::sin(t);
  }
  if (with_nan && count > 0) out[count / 2] = std::numeric_limits<double>::quiet_NaN();
  return out;
}

}  // namespace percuss::fuzz
