#include "cli/provenance.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.hpp"

namespace percuss::tools {
namespace {

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::string out = "percuss";
  std::size_t at = bytes.find('\0');  // skip the path of the program
  while (at != std::string::npos && at + 1 < bytes.size()) {
    const std::size_t end = bytes.find('\0', at + 1);
    out += ' ' + shell_quoted_argument(bytes.substr(at + 1, end - at - 1));
    at = end;
  }
  return out;
}

std::time_t now() {
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  if (fixed == nullptr) return std::time(nullptr);
  constexpr std::time_t kLast = 253402300799;  // 9999-12-31
  const std::string_view text = fixed;
  std::time_t value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (whole && value >= 0 && value <= kLast) return value;
  throw UsageError("SOURCE_DATE_EPOCH is not a time", "give seconds since 1970, or unset it");
}

}  // namespace

std::string shell_quoted_argument(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./:,=+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

report::Provenance provenance_now(const OutputFlags& flags) {
  return {.command = flags.equivalent_command.empty() ? command_line() : flags.equivalent_command,
          .made_at = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(now()))};
}

}  // namespace percuss::tools
