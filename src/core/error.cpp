#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/visible_text.hpp"

namespace percuss {
inline namespace core {

namespace {

constexpr std::size_t kMaxField_bytes = 600;

}  // namespace

std::string one_line(std::string_view text, std::size_t limit) {
  std::string out;
  while (!text.empty()) {
    const std::string shown = take_visible(text);
    if (out.size() + shown.size() > limit) return out + "...";
    out += shown;
  }
  return out;
}

bool is_machine_fault(int error) {
  constexpr std::array kFaults{EAGAIN, ENOMEM, EMFILE, ENFILE, ENOBUFS, ENOSPC, EDQUOT, EFBIG, EIO, ESTALE, ETIMEDOUT};
  return std::find(kFaults.begin(), kFaults.end(), error) != kFaults.end();
}

void throw_system_error(std::string_view problem, int error, std::string_view where, std::string_view remedy) {
  const std::string text = fmt::format("{}: {}", problem, std::generic_category().message(error));
  if (is_machine_fault(error)) throw MachineFault(text, where, remedy);
  throw InputError(text, where, remedy);
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
