#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::fuzz {

inline constexpr std::size_t kMaxElements = 1U << 14U;  // of a data set or variable with values

/// A line of a recipe, for example "set accel f8 2,1,16". A recipe states the contents of a binary file as text, which
/// a fuzzer can mutate. Each line states one data set, variable, attribute, group or link. Blanks separate its words,
/// commas the items of a list.
struct RecipeLine {
  std::vector<std::string> words;

  /// The word at an index; empty beyond the end.
  std::string word(std::size_t at) const { return at < words.size() ? words[at] : std::string(); }
  bool has(std::string_view option) const;
  /// The numbers in the list at an index, at most 64.
  std::vector<double> numbers(std::size_t at) const;
  /// The numbers as sizes. A size that is negative or above `largest` becomes `largest`.
  std::vector<std::size_t> sizes(std::size_t at, std::size_t largest) const;
};

/// The lines of a recipe, at most 24.
std::vector<RecipeLine> recipe_lines(std::string_view text);

/// `count` values: a pulse and a decay, with a NaN in the middle if `with_nan`.
std::vector<double> recipe_values(std::size_t count, bool with_nan);

}  // namespace percuss::fuzz
