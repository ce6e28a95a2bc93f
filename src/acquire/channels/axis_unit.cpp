#include "acquire/channels/axis_unit.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

std::optional<double> Hz_per_unit(const std::string& unit) {
  const std::string lower = lower_case(unit);
  if (lower.empty() || lower == "none" || lower == "-" || lower == "hz" || lower == "hertz") return 1;
  if (lower == "khz") return 1e3;
  if (unit == "MHz") return 1e6;
  if (lower == "rad/s") return 1 / kTwoPi;
  if (lower == "rpm" || lower == "cpm" || lower == "1/min") return 1 / 60.0;
  return std::nullopt;
}

double require_Hz_per_unit(const std::string& unit, const std::string& where) {
  if (const auto to_Hz = Hz_per_unit(unit)) return *to_Hz;
  throw InputError(fmt::format("the unit of the frequencies, {}, is not known", one_line(unit, 20)), where,
                   "give them in Hz, kHz, MHz, rad/s or rpm");
}

std::optional<double> s_per_unit(const std::string& unit) {
  const auto parsed = parse_unit(unit);
  return parsed && parsed->quantity == Quantity::time ? std::optional(parsed->to_SI) : std::nullopt;
}

void require_plausible_times(double fs_Hz, const std::string& name, const std::string& where,
                             const std::string& remedy) {
  constexpr double kMilli = 1000;
  if (fs_Hz >= kMinTestRate_Hz) return;
  throw InputError(fmt::format("{} states no unit: its steps give {:.6g} Hz if they are seconds and {:.6g} Hz if they "
                               "are milliseconds",
                               name, fs_Hz, kMilli * fs_Hz),
                   where, remedy, {"fs"});
}

}  // namespace percuss::acquire
