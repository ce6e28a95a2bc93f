#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace percuss {
inline namespace core {

namespace {

constexpr std::size_t kMaxField_bytes = 600;

// The last position up to `limit` that is not inside a UTF-8 character. A text without the start of a character in the
// four bytes that end at index `limit` is not UTF-8: it is cut at `limit`.
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

UsageError::UsageError(std::string_view problem, std::string_view remedy)
    : std::runtime_error(fmt::format("{}; {}", one_line(problem, kMaxField_bytes), one_line(remedy, kMaxField_bytes))) {
}

}  // namespace core
}  // namespace percuss

namespace percuss {

std::string Message::written(OptionWriter write) const {
  std::string list, other_commands;
  for (const OptionId& id : options) {
    std::string& part = id.find('.') == std::string::npos ? list : other_commands;
    part += (part.empty() ? "" : ", ") + write(id);
  }
  if (!other_commands.empty()) list += (list.empty() ? "see " : "; see ") + other_commands;
  return list.empty() ? text : fmt::format("{} ({})", text, list);
}

InputError::InputError(std::string_view problem, std::string_view where, std::string_view remedy,
                       std::vector<OptionId> options)
    : std::runtime_error(fmt::format("{} ({}); {}", one_line(problem, kMaxField_bytes),
                                     one_line(where, kMaxField_bytes), one_line(remedy, kMaxField_bytes))),
      problem_(one_line(problem, kMaxField_bytes)),
      where_(one_line(where, kMaxField_bytes)),
      remedy_(one_line(remedy, kMaxField_bytes)),
      options_(std::move(options)) {}

std::string InputError::written(OptionWriter write) const { return Message{what(), options_}.written(write); }

}  // namespace percuss
