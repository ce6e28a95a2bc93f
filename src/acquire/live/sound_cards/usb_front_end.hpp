#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace percuss::acquire {

/// A front end for IEPE sensors or a digital accelerometer that is a USB sound card of two channels (The Modal Shop
/// 485B39, 333D01 and relatives). Its calibration is in its product string.
struct UsbFrontEnd {
  std::string model, serial, calibrated;  // the date as YYYY-MM-DD
  std::string unit;                       // "V" or "m/s^2"
  std::array<double, 2> full_scales{};    // in `unit`, per channel
};

/// Parses the product string: model (6 characters), a separator, the kind of data, serial number (6), for each channel
/// the 24-bit counts per unit, date (YYMMDD). The kind states the unit and the digits of a count: 1: m/s², 5 digits;
/// 2: V, 7 digits; 3: 50 mV, 7 digits. Nothing where the text is no product string of a front end.
std::optional<UsbFrontEnd> parse_front_end(std::string_view product);

/// The front end behind a sound card, from its product string in sysfs. `sysfs` is "/sys", or a copy for tests.
std::optional<UsbFrontEnd> front_end_of_card(int card, const std::string& sysfs = "/sys");

/// The number of the card in a name of PortAudio, such as 1 in "485B39: USB Audio (hw:1,0)".
std::optional<int> card_in_name(std::string_view name);

}  // namespace percuss::acquire
