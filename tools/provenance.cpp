#include "provenance.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

namespace percuss::tools {
namespace {

// As a shell would take it again.
std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./:,=+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::string out = "percuss";
  std::size_t at = bytes.find('\0');  // how the program was called is no part of what it did
  while (at != std::string::npos && at + 1 < bytes.size()) {
    const std::size_t end = bytes.find('\0', at + 1);
    out += ' ' + quoted(bytes.substr(at + 1, end - at - 1));
    at = end;
  }
  return out;
}

std::time_t now() {
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  return fixed != nullptr ? static_cast<std::time_t>(std::strtoll(fixed, nullptr, 10)) : std::time(nullptr);
}

}  // namespace

Provenance provenance_now() {
  return {.command = command_line(), .made_at = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(now()))};
}

}  // namespace percuss::tools
