#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/live/sample_stream.hpp"
#include "acquire/record/record.hpp"
#include "core/error.hpp"

namespace percuss::pipeline {

/// The sampling rate over the highest frequency that a recorder's anti-alias filter usually passes.
inline constexpr double kRateOverBand = 2.56;

/// Which channels of a device are the force and the responses, and their units.
struct LiveChannels {
  std::size_t force = 0;           // index into a frame
  std::vector<std::size_t> accel;  // likewise
  double force_to_N = 1;
  std::vector<double> accel_to_mps2;
  std::vector<std::string> accel_names;    // for people
  std::size_t force_number = 1;            // of the device's channel, from 1
  std::vector<std::size_t> accel_numbers;  // likewise
  std::vector<Message> notes;              // assumptions about units
  /// The record that the file will hold, without rows: signals as a reader of the file finds them.
  acquire::Record description;
};

/// "channel 3 (accel 2)": a response, for people, by the number of the device and the name in the file; with its own
/// name, if it has one.
std::string name_of_channel(const LiveChannels& channels, std::size_t accel);

/// Finds the roles by the rules of record files: the set-up, units, words in the names. Without any of these, the first
/// channel is the force. Numbers in the set-up are those of the device; entries of channels that are not recorded are
/// left out. The notes begin with those of the device. Where the same unit is assumed for several channels, one note
/// states it for all of them.
/// errors  InputError: fewer than two channels, unknown or contradictory units.
LiveChannels live_channels(const acquire::StreamFormat& format, const acquire::ReadOptions& stated,
                           std::vector<Message> device_notes = {});

}  // namespace percuss::pipeline
