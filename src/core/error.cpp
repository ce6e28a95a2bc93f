#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace percuss::inline core {

namespace {

// The last place up to `limit` that is not inside a UTF-8 character. Where no character starts within the four bytes
// before it the text is no UTF-8, and is cut where it is.
std::size_t cut_at(std::string_view text, std::size_t limit) {
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
  if (text.size() <= limit) return text.size();
  std::size_t cut = limit;
  while (cut > 0 && limit - cut < 3 && continues(cut)) --cut;
  return continues(cut) ? limit : cut;
}

}  // namespace

std::string one_line(std::string_view text, std::size_t limit) {
  std::string out;
  for (const char c : text.substr(0, cut_at(text, limit))) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  if (text.size() > limit) out += "...";
  return out;
}

std::string Message::written(OptionWriter write) const {
  std::string list;
  for (const OptionId& id : options) list += (list.empty() ? "" : ", ") + write(id);
  return list.empty() ? text : fmt::format("{} ({})", text, list);
}

UsageError::UsageError(std::string_view problem, std::string_view remedy)
    : std::runtime_error(fmt::format("{}; {}", one_line(problem, 600), one_line(remedy, 600))) {}

}  // namespace percuss::inline core

namespace percuss {

InputError::InputError(std::string_view problem, std::string_view where, std::string_view remedy,
                       std::vector<OptionId> options)
    : std::runtime_error(
          fmt::format("{} ({}); {}", one_line(problem, 600), one_line(where, 600), one_line(remedy, 600))),
      problem_(problem),
      where_(where),
      remedy_(remedy),
      options_(std::move(options)) {}

InputError::InputError(const std::string& message, std::vector<OptionId> options)
    : std::runtime_error(message), problem_(message), options_(std::move(options)) {}

InputError InputError::with_message(const std::string& message, std::vector<OptionId> options) {
  return {message, std::move(options)};
}

std::string InputError::written(OptionWriter write) const { return Message{what(), options_}.written(write); }

}  // namespace percuss
