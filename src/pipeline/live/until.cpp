#include "pipeline/live/until.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace percuss::pipeline {
namespace {

using identify::ModeType;

constexpr double kPercent = 0.01;
constexpr int kMaxNumber = 999;

[[noreturn]] void refuse(std::string_view goal, const std::string& problem) {
  throw InputError(fmt::format("'{}': {}", one_line(goal, 60), problem), "the goal",
                   R"(give goals such as "hoop1<0.05Hz", "bending 2 < 0.1 %" or "mode 3<0.2Hz")", {"until"});
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string lower_without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (!is_blank(c)) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

// Takes `word` from the start of `text`.
bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

PrecisionGoal parse_goal(std::string_view written) {
  const std::string plain = lower_without_blanks(written);
  std::string_view rest = plain;
  PrecisionGoal goal;
  if (rest.empty()) refuse(written, "no goal");
  if (take(rest, "bending")) {
    goal.type = ModeType::bending;
  } else if (take(rest, "hoop")) {
    goal.type = ModeType::hoop;
  } else if (!take(rest, "mode")) {
    refuse(written, "does not begin with bending, hoop or mode");
  }
  const auto number = std::from_chars(rest.data(), rest.data() + rest.size(), goal.number);
  if (number.ec != std::errc{} || goal.number < 1 || goal.number > kMaxNumber)
    refuse(written, "the mode's number is missing or not from 1 to 999");
  rest.remove_prefix(static_cast<std::size_t>(number.ptr - rest.data()));
  if (!take(rest, "<")) refuse(written, "no '<' after the mode");
  take(rest, "=");
  const auto limit = std::from_chars(rest.data(), rest.data() + rest.size(), goal.limit);
  if (limit.ec != std::errc{} || !(goal.limit > 0) || !std::isfinite(goal.limit))
    refuse(written, "the limit is not a number above 0");
  rest.remove_prefix(static_cast<std::size_t>(limit.ptr - rest.data()));
  if (rest == "%") {
    goal.relative = true;
    goal.limit *= kPercent;
  } else if (rest != "hz") {
    refuse(written, rest.empty() ? "the limit has no unit (Hz or %)" : "the limit's unit is not Hz or %");
  }
  return goal;
}

}  // namespace

std::string PrecisionGoal::text() const {
  const std::string name = type == ModeType::unknown ? "mode" : identify::name_of(type);
  return relative ? fmt::format("{} {} < {:.6g} %", name, number, limit / kPercent)
                  : fmt::format("{} {} < {:.6g} Hz", name, number, limit);
}

std::vector<PrecisionGoal> parse_goals(std::string_view text) {
  std::vector<PrecisionGoal> goals;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    goals.push_back(parse_goal(text.substr(0, comma)));
    if (comma == text.size()) return goals;
    text.remove_prefix(comma + 1);
  }
}

std::optional<std::size_t> mode_of(const PrecisionGoal& goal, const SessionQuality& quality) {
  std::optional<std::size_t> farthest;
  double largest = -1;  // ± over the limit
  for (std::size_t m = 0; m < quality.modes.size(); ++m) {
    const LiveMode& mode = quality.modes[m];
    const bool named = goal.type == ModeType::unknown ? static_cast<std::size_t>(goal.number) == m + 1
                                                      : mode.type == goal.type && mode.order == goal.number;
    if (!named) continue;
    const bool known = mode.freq_std_Hz > 0;
    const double distance = known ? mode.freq_std_Hz / limit_Hz(goal, mode) : std::numeric_limits<double>::infinity();
    if (distance <= largest) continue;
    largest = distance;
    farthest = m;
  }
  return farthest;
}

double limit_Hz(const PrecisionGoal& goal, const LiveMode& mode) {
  return goal.relative ? goal.limit * mode.freq_Hz : goal.limit;
}

bool is_met(const PrecisionGoal& goal, const SessionQuality& quality) {
  const auto m = mode_of(goal, quality);
  if (quality.blows < kMinBlowsForGoals || !m) return false;
  const LiveMode& mode = quality.modes[*m];
  return mode.freq_std_Hz > 0 && mode.freq_std_Hz < limit_Hz(goal, mode);
}

bool all_met(const std::vector<PrecisionGoal>& goals, const SessionQuality& quality) {
  return std::all_of(goals.begin(), goals.end(), [&](const PrecisionGoal& goal) { return is_met(goal, quality); });
}

}  // namespace percuss::pipeline
