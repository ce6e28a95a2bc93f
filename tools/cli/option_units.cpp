#include "cli/option_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/io/csv_text.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

// The sensitivities have their SI values in V per N, m/s² and Pa.
enum class Dimension {
  length,
  mass,
  speed,
  acceleration,
  frequency,
  inertia,
  volts_per_force,
  volts_per_accel,
  volts_per_pressure
};

struct UnitOfValue {
  std::string_view name;
  Dimension dimension;
  double si;
};
constexpr double kFoot_m = 12 * kInch_m;
constexpr std::array<UnitOfValue, 36> kUnits{{{"m", Dimension::length, 1},
                                              {"cm", Dimension::length, 0.01},
                                              {"mm", Dimension::length, 0.001},
                                              {"in", Dimension::length, kInch_m},
                                              {"ft", Dimension::length, kFoot_m},
                                              {"kg", Dimension::mass, 1},
                                              {"g", Dimension::mass, 0.001},
                                              {"oz", Dimension::mass, kOunce_kg},
                                              {"lb", Dimension::mass, kPound_kg},
                                              {"lbs", Dimension::mass, kPound_kg},
                                              {"m/s", Dimension::speed, 1},
                                              {"km/h", Dimension::speed, 1 / 3.6},
                                              {"mph", Dimension::speed, kMilePerHour_mps},
                                              {"ft/s", Dimension::speed, kFoot_m},
                                              {"m/s2", Dimension::acceleration, 1},
                                              {"in/s2", Dimension::acceleration, kInch_m},
                                              {"ft/s2", Dimension::acceleration, kFoot_m},
                                              {"Hz", Dimension::frequency, 1},
                                              {"kHz", Dimension::frequency, 1e3},
                                              {"MHz", Dimension::frequency, 1e6},
                                              {"kgm2", Dimension::inertia, 1},
                                              {"ozin2", Dimension::inertia, kOunce_kg* kInch_m* kInch_m},
                                              {"mV/N", Dimension::volts_per_force, 1e-3},
                                              {"V/N", Dimension::volts_per_force, 1},
                                              {"mV/lbf", Dimension::volts_per_force, 1e-3 / kPoundForce_N},
                                              {"V/lbf", Dimension::volts_per_force, 1 / kPoundForce_N},
                                              {"mV/g", Dimension::volts_per_accel, 1e-3 / kStandardGravity_mps2},
                                              {"V/g", Dimension::volts_per_accel, 1 / kStandardGravity_mps2},
                                              {"mV/(m/s^2)", Dimension::volts_per_accel, 1e-3},
                                              {"mV/(m/s2)", Dimension::volts_per_accel, 1e-3},
                                              {"mV/(m/s\u00B2)", Dimension::volts_per_accel, 1e-3},
                                              {"V/(m/s^2)", Dimension::volts_per_accel, 1},
                                              {"V/(m/s2)", Dimension::volts_per_accel, 1},
                                              {"V/(m/s\u00B2)", Dimension::volts_per_accel, 1},
                                              {"mV/Pa", Dimension::volts_per_pressure, 1e-3},
                                              {"V/Pa", Dimension::volts_per_pressure, 1}}};

struct Placeholder {
  std::string_view shown, unit;
};
constexpr std::array<Placeholder, 14> kPlaceholders{{{"M", "m"},
                                                     {"IN", "in"},
                                                     {"KG", "kg"},
                                                     {"OZ", "oz"},
                                                     {"G", "g"},
                                                     {"M/S", "m/s"},
                                                     {"MPH", "mph"},
                                                     {"IN/S2", "in/s2"},
                                                     {"HZ", "Hz"},
                                                     {"KG*M2", "kgm2"},
                                                     {"OZIN2", "ozin2"},
                                                     {"mV/N", "mV/N"},
                                                     {"mV/g", "mV/g"},
                                                     {"mV/Pa", "mV/Pa"}}};

// Hz and kHz in any case; a prefix m or M keeps its meaning.
std::string_view usual_case(std::string_view name) {
  const std::string lower = lower_case(name);
  return lower == "hz" ? "Hz" : lower == "khz" ? "kHz" : name;
}

const UnitOfValue* unit_named(std::string_view written) {
  const std::string_view name = usual_case(written);
  const auto* const at =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const UnitOfValue& u) { return u.name == name; });
  return at == kUnits.end() ? nullptr : at;
}

const UnitOfValue* unit_of_option(std::string_view placeholder) {
  constexpr std::string_view kList = ",...";  // each value of a list has a unit of its own
  if (placeholder.ends_with(kList)) placeholder.remove_suffix(kList.size());
  for (const Placeholder& p : kPlaceholders) {
    if (p.shown == placeholder) return unit_named(p.unit);
  }
  return nullptr;
}

}  // namespace

bool has_option_units(std::string_view placeholder) { return unit_of_option(placeholder) != nullptr; }

NumberAndUnit split_unit(std::string_view text) {
  text = trimmed(text);
  if (parse_number(text, false).problem == NumberProblem::none) return {.number = text, .unit = {}};
  // The 2 of m/s2 and of mV/(m/s^2) belongs to the unit.
  const std::string_view bare = text.ends_with(')') ? text.substr(0, text.size() - 1) : text;
  const std::size_t before = bare.ends_with('2') && bare.size() > 1 ? bare.size() - 2 : std::string_view::npos;
  const std::size_t digits = text.find_last_of("0123456789.", before) + 1;  // 0 for none
  return {.number = text.substr(0, digits), .unit = trimmed(text.substr(digits))};
}

std::string in_option_unit(const std::string& text, std::string_view placeholder) {
  const UnitOfValue* const wanted = unit_of_option(placeholder);
  const NumberAndUnit parts = split_unit(text);
  const UnitOfValue* const given = unit_named(parts.unit);
  const ParsedNumber number = parse_number(parts.number, false);
  const bool converts = wanted != nullptr && given != nullptr && given->dimension == wanted->dimension;
  if (!converts || number.problem != NumberProblem::none) return text;
  if (given == wanted) return std::string(parts.number);
  const double value = number.value * given->si / wanted->si;
  // Frequencies are round numbers: 1.001 kHz is 1001 Hz, but the product of the doubles is not.
  return given->dimension == Dimension::frequency ? fmt::format("{:.15g}", value) : fmt::format("{}", value);
}

}  // namespace percuss::tools
