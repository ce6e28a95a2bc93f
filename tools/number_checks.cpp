#include "number_checks.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/error.hpp"

namespace percuss::tools {
namespace {

double number_in(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);  // from_chars takes none
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

CLI::Validator check(const char* wanted, const std::function<bool(double)>& holds) {
  return {[wanted, holds](std::string& text) {
            const double value = number_in(text);
            return std::isfinite(value) && holds(value) ? std::string()
                                                        : "'" + one_line(text, 40) + "' is not " + wanted;
          },
          ""};
}

}  // namespace

CLI::Validator above_zero() {
  return check("a number above 0", [](double value) { return value > 0; });
}

CLI::Validator not_negative() {
  return check("a number from 0 up", [](double value) { return value >= 0; });
}

CLI::Validator finite() {
  return check("a number", [](double) { return true; });
}

CLI::Validator counted() {
  return {[](std::string& text) {
            const bool digits =
                !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
            return digits ? std::string() : "'" + one_line(text, 40) + "' is not a whole number from 0 up";
          },
          ""};
}

}  // namespace percuss::tools
