#pragma once
#include <string>
#include <string_view>

namespace percuss::tools {

/// A value with a unit, such as "136mph" for an option in M/S, as the number in the option's unit. The placeholder
/// names the option's unit: M, IN, KG, OZ, G, M/S, MPH, IN/S2, HZ, KG*M2, OZIN2, mV/N, mV/g, mV/Pa, or a list of them
/// (IN,...). Accepted units: lengths m, cm, mm, in, ft; masses kg, g, oz, lb, lbs; speeds m/s, km/h, mph, ft/s;
/// accelerations m/s2, in/s2, ft/s2; frequencies Hz, kHz, MHz; moments of inertia kgm2, ozin2; sensitivities mV or V
/// per N, lbf, g, m/s^2 or Pa. Any other text stays unchanged.
std::string in_option_unit(const std::string& text, std::string_view placeholder);

/// The number of "136 mph", and its unit, which is empty if none follows.
struct NumberAndUnit {
  std::string_view number, unit;
};
NumberAndUnit split_unit(std::string_view text);

/// Whether in_option_unit() converts to the unit of the placeholder.
bool has_option_units(std::string_view placeholder);

}  // namespace percuss::tools
