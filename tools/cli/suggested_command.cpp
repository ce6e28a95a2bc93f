#include "cli/suggested_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/shell_argument.hpp"
#include "core/error.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxCommand_bytes = 300;  // a longer one hides its options

// For a message of one line.
std::string quoted(const std::string& word) { return one_line(shell_quoted_argument(word), std::string::npos); }

// Whether the word is an option that the guess replaces.
bool is_role_option(std::string_view word) {
  return word.starts_with("--force-channel") || word.starts_with("--accel-channel");
}

// Without a force, these commands have no result.
bool needs_force(std::string_view command) {
  constexpr std::array<std::string_view, 4> kCommands{"frf", "survey", "nodes", "calibrate"};
  return std::find(kCommands.begin(), kCommands.end(), command) != kCommands.end();
}

}  // namespace

std::string suggested_options(const acquire::RoleGuess& guess) {
  if (guess.accel.empty()) return "";
  if (guess.frf_table) return "--frf-kind accelerance";
  std::string options = guess.force.empty() ? "" : "--force-channel " + quoted(guess.force) + " ";
  options += "--accel-channel " + quoted(fmt::format("{}", fmt::join(guess.accel, ",")));
  if (guess.force_in_volts) options += " --force-sensitivity NUMBERmV/N";
  if (guess.in_volts) options += " --accel-sensitivity NUMBERmV/g";
  if (guess.assumed_rate_Hz > 0) return options + fmt::format(" --fs {:.6g}", guess.assumed_rate_Hz);
  return options + (guess.rate_known ? "" : " --fs HZ");
}

std::string suggested_command(const std::vector<std::string>& typed, const acquire::RoleGuess& guess) {
  if (guess.accel.empty() || typed.empty()) return "";
  if (guess.force.empty() && !guess.frf_table && typed.size() > 1 && needs_force(typed[1]))
    return "; no channel looks like a force, and percuss " + typed[1] + " needs one; percuss analyze does not";
  std::string command = "percuss";
  for (std::size_t i = 1; i < typed.size(); ++i) {
    if (is_role_option(typed[i])) {
      i += typed[i].find('=') == std::string::npos ? 1U : 0U;
      continue;
    }
    command += " " + quoted(typed[i]);
  }
  const std::string options = suggested_options(guess);
  command += " " + options;
  return "; the samples suggest: " + (command.size() > kMaxCommand_bytes ? options : command);
}

}  // namespace percuss::tools
