#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::fuzz {

inline constexpr std::size_t kMaxElements = 1U << 14U;  // of a part with values

/// A line of a recipe: the contents of a binary file as text, which mutations can change. Each line is a part, with
/// words separated by blanks and lists separated by commas ("set accel f8 2,1,16").
struct RecipeLine {
  std::vector<std::string> words;

  /// The word at an index; empty beyond the end.
  std::string word(std::size_t at) const { return at < words.size() ? words[at] : std::string(); }
  bool has(std::string_view option) const;
  std::vector<double> numbers(std::size_t at) const;
  /// Whole numbers, each at most `largest`.
  std::vector<std::size_t> sizes(std::size_t at, std::size_t largest) const;
};

/// The lines of a recipe, at most 24.
std::vector<RecipeLine> recipe_lines(std::string_view text);

/// `count` values of a part: a pulse and a decay, with a NaN if `with_nan`.
std::vector<double> recipe_values(std::size_t count, bool with_nan);

}  // namespace percuss::fuzz
