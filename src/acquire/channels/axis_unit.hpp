#pragma once
#include <optional>
#include <string>

namespace percuss::acquire {

/// Hz per unit of an axis of frequencies: Hz, hertz, kHz, MHz, rad/s, rpm, cpm, 1/min; 1 where no unit is stated ("",
/// "none", "-"). Nothing for other texts.
std::optional<double> Hz_per_unit(const std::string& unit);

/// As Hz_per_unit, but refuses other texts.
/// errors  InputError at `where`: another text
double require_Hz_per_unit(const std::string& unit, const std::string& where);

/// Seconds per unit of an axis of times; nothing where the text is no unit of time.
std::optional<double> s_per_unit(const std::string& unit);

/// The lowest rate of a hammer test. Times without a unit that give a lower rate are probably milliseconds.
inline constexpr double kMinTestRate_Hz = 200;

/// errors  InputError at `where`, with the option "fs": a rate of the axis `name` below kMinTestRate_Hz
void require_plausible_times(double fs_Hz, const std::string& name, const std::string& where,
                             const std::string& remedy);

}  // namespace percuss::acquire
