#include "core/error.hpp"

#include <fmt/format.h>

namespace percuss {

std::string one_line(std::string_view text, std::size_t limit) {
  std::string out;
  for (const char c : text.substr(0, limit)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  if (text.size() > limit) out += "...";
  return out;
}

InputError::InputError(std::string_view problem, std::string_view where, std::string_view remedy)
    : std::runtime_error(
          fmt::format("{} ({}); {}", one_line(problem, 600), one_line(where, 600), one_line(remedy, 600))) {}

UsageError::UsageError(std::string_view problem, std::string_view remedy)
    : std::runtime_error(fmt::format("{}; {}", one_line(problem, 600), one_line(remedy, 600))) {}

}  // namespace percuss
