#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/error.hpp"

namespace percuss::tools {

/// What the samples of one channel show.
struct ChannelSamples {
  double rms = 0, peak = 0;         // in SI; the peak is the largest magnitude, with its sign
  double hammer_dissimilarity = 1;  // acquire::hammer_dissimilarity
  bool hammer = false;              // looks like a hammer; false for all responses if the force does
  std::vector<double> envelope{};   // largest magnitudes over time
};

/// A channel of a record, as info describes it.
struct Channel {
  const acquire::SignalInfo* signal = nullptr;  // of the record
  const char *role = "", *si_unit = "";
  std::optional<ChannelSamples> samples{};  // nothing if they could not be read
};

/// What the samples of a record show.
struct RecordSamples {
  std::vector<Channel> channels;      // the force, if there is one, then the accelerations
  std::optional<std::size_t> hits;    // with a pulse; nothing without a force and for long records
  bool partial = false;               // a long record: only its beginning was read
  std::optional<InputError> problem;  // why samples could not be read
};

/// Reads up to 4 million samples of each channel. The result points into `record`. Never throws for samples that cannot
/// be read.
RecordSamples samples_of(const acquire::Record& record);

/// The record's notes, and what the samples suggest: channels that look like another role.
std::vector<Message> notes_of(const acquire::Record& record, const RecordSamples& samples);

/// The envelope as a line of block characters, scaled to its largest value.
std::string picture_of(std::span<const double> envelope);

}  // namespace percuss::tools
