#pragma once
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss {
inline namespace core {

inline constexpr double kStandardGravity_mps2 = 9.80665;  // exact by definition, [1] in docs/theory/sources.md
inline constexpr double kPoundForce_N = 4.4482216152605;  // exact by definition, [1]
inline constexpr double kInch_m = 0.0254;                 // exact by definition, [1]
inline constexpr double kPound_kg = 0.45359237;           // exact by definition, [1]
inline constexpr double kOunce_kg = kPound_kg / 16;
inline constexpr double kMilePerHour_mps = 5280 * 12 * kInch_m / 3600;
inline constexpr double kTwoPi = 2 * std::numbers::pi;
inline constexpr double kRadian_deg = 180 / std::numbers::pi;
inline constexpr double kDegree_rad = std::numbers::pi / 180;

enum class Quantity { force, acceleration, voltage, time, angle, length, mass, pressure, velocity };

/// Whether a quantity is the response of a structure: acceleration or sound pressure.
constexpr bool is_response(Quantity quantity) {
  return quantity == Quantity::acceleration || quantity == Quantity::pressure;
}

/// A unit: its quantity, and its size in SI units (V for voltage, rad for angle).
struct Unit {
  Quantity quantity;
  double to_SI;
};

/// Parses the name of a unit as instruments write it.
///   force N mN kN lbf lb-f kgf · acceleration m/s^2 mm/s^2 cm/s^2 in/s^2 ft/s^2 g mg · voltage V mV µV · time s ms us
///   min · angle deg rad · length m mm cm in ft · mass kg lb lbs oz ·
///   pressure Pa kPa mPa uPa · velocity m/s mm/s cm/s in/s ft/s
/// Squares may be ^2, **2, 2 or ² (UTF-8 or Latin-1), products and quotients m/s/s, m*s^-2, m·s-2, m_s2 or mps2; micro
/// is u or µ. Case matters where it changes the unit (mg is milli-g; Mg is unknown). Surrounding spaces and brackets
/// are ignored. Plain g is standard gravity, never gram, and mN is millinewton. Returns nothing for an unknown name.
std::optional<Unit> parse_unit(std::string_view name);

/// As parse_unit; lb and lbs are pounds of force where `wanted` is a force. `where` is the place for the message.
/// errors  InputError: unknown, or not a unit of `wanted`
Unit require_unit(std::string_view name, Quantity wanted, std::string_view where);
/// As above; `options` are the options by which the user states the unit, for the message.
Unit require_unit(std::string_view name, Quantity wanted, std::string_view where, const std::vector<OptionId>& options);

/// The SI name of a quantity: N, m/s^2, V, s, rad, m, kg, Pa, m/s.
std::string si_name(Quantity quantity);

}  // namespace core
}  // namespace percuss
