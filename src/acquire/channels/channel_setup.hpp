#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Reads a channel set-up: a JSON array with one object per channel (docs/reference/formats.md, "Channel
/// set-up").
///   name (required)          the column's name or 1-based number, or the data set's channel ("accel 1")
///   role                     "force", "acceleration" or "ignore"
///   sign                     1 or -1
///   direction                "+x", "-x", … "-z": the direction of a positive value, in place of sign
///   angle_deg, position_m    of the sensor
///   sensitivity, sensitivity_unit   both or none: 2.25 and "mV/N"
///   unit                     of the stored numbers
///   instrument               sensor, amplifier, serial numbers: for reports
/// errors  InputError with file and key: not such a document, an unknown or duplicate key, a value of the wrong type or
/// out of range, two entries for one name, a second force, nested deeper than 16, more than 4096 entries, longer than
/// 1 MiB.
std::vector<ChannelSetup> read_channel_setup(const std::string& path);

/// As read_channel_setup, for a document in memory; `where` names it.
std::vector<ChannelSetup> parse_channel_setup(std::string_view json, const std::string& where);

/// The instruments that measured a channel, in the user's words.
struct ChannelInstrument {
  std::string channel, instrument;
};

/// The instruments of a set-up file that read_channel_setup accepts, in its order; channels without one are left out.
std::vector<ChannelInstrument> instruments_of_setup(const std::string& path);

/// An example: a hammer and two accelerometers.
std::string channel_setup_example();

}  // namespace percuss::acquire
