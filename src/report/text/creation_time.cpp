#include "report/text/creation_time.hpp"

#include <fmt/chrono.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <system_error>

#include "core/error.hpp"

namespace percuss::report {
namespace {

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

std::string creation_time() { return fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(now())); }

}  // namespace percuss::report
