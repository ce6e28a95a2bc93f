#include "acquire/record/note_on_rounding.hpp"

#include <fmt/format.h>

#include "core/io/significant_digits.hpp"

namespace percuss::acquire {

Message note_on_rounding(const std::string& text, double largest_error, const OptionId& option) {
  constexpr double kHarmless = 1e-4;
  const std::string ppm = significant(largest_error * 1e6, 2);
  Message note(
      fmt::format("{}. If the true value is another one, all frequencies are off, by at most {} ppm", text, ppm),
      {option});
  note.information = largest_error < kHarmless;
  return note;
}

}  // namespace percuss::acquire
