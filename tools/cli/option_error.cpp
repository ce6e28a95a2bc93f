#include "cli/option_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxValueBytes = 80;

// "--period-s, --gate-times-s and --moi-oz-in2".
std::string enumerated(const std::vector<OptionId>& options, OptionWriter write) {
  std::string out;
  for (std::size_t i = 0; i < options.size(); ++i)
    out += (i == 0 ? "" : i + 1 == options.size() ? " and " : ", ") + write(options[i]);
  return out;
}

std::string same_id(std::string_view id) { return std::string(id); }

std::string subject_and_problem(const std::vector<OptionId>& options, std::string_view problem, OptionWriter write) {
  return options.empty() ? std::string(problem) : fmt::format("{} {}", enumerated(options, write), problem);
}

}  // namespace

OptionError::OptionError(std::vector<OptionId> options, std::string_view problem, std::string_view remedy,
                         std::vector<OptionId> remedy_options)
    : UsageError(subject_and_problem(options, problem, same_id), remedy),
      options_(std::move(options)),
      remedy_options_(std::move(remedy_options)),
      problem_(problem),
      remedy_(remedy) {}

OptionError OptionError::wrong_value(const OptionId& option, std::string_view value, std::string_view remedy,
                                     std::string_view reason, std::vector<OptionId> remedy_options) {
  const std::string shown = one_line(value, kMaxValueBytes);
  const std::string problem = fmt::format("cannot be '{}'{}{}", shown, reason.empty() ? "" : ": ", reason);
  OptionError error({option}, problem, remedy, std::move(remedy_options));
  error.value_ = value;
  return error;
}

std::string OptionError::written(OptionWriter write) const {
  const UsageError plain(subject_and_problem(options_, problem_, write), remedy_);
  return Message{plain.what(), remedy_options_}.written(write);
}

}  // namespace percuss::tools
