#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::fuzz {

inline constexpr std::size_t kMaxElements = 1U << 14U;  // of a part that is filled

/// What a file of a library's format is to hold, as text that people and mutations can write: a line per part, words
/// between blanks, lists with commas ("set accel f8 2,1,16").
struct RecipeLine {
  std::vector<std::string> words;

  /// A word by its place; empty beyond the end.
  std::string word(std::size_t at) const { return at < words.size() ? words[at] : std::string(); }
  bool has(std::string_view option) const;
  std::vector<double> numbers(std::size_t at) const;
  /// Whole numbers, each at most `largest`.
  std::vector<std::size_t> sizes(std::size_t at, std::size_t largest) const;
};

/// The lines of a recipe, at most 24.
std::vector<RecipeLine> recipe_lines(std::string_view text);

/// Values for a part of so many elements: a pulse and a decay, or one that is not finite among them.
std::vector<double> recipe_values(std::size_t count, bool with_nan);

}  // namespace percuss::fuzz
