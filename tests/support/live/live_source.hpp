#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/live/sample_stream.hpp"
#include "acquire/record/record.hpp"

namespace percuss::test {

/// Keeps the events of a session in memory.
struct MemoryLog : acquire::SessionLog {
  std::vector<std::string> events;
  void append_event(const std::string& json) override { events.push_back(json); }
};

/// A row of a record as the frames of a device: the force, then the responses, in SI units.
struct LiveSource {
  acquire::StreamFormat format;
  std::vector<double> values;  // [frames × channels]

  explicit LiveSource(const acquire::Record& record, std::size_t row = 0);
  std::size_t frames() const { return values.size() / format.channels; }
  acquire::SampleBlock block(std::size_t first, std::size_t count) const;
};

/// The sampling rate of struck_tube, and its channels: the force and two responses.
inline constexpr double kTubeRate_Hz = 4096;
inline constexpr std::size_t kTubeChannels = 3;
/// One long row, sampled at kTubeRate_Hz, of a tube that is struck at these times. Its modes: 200 Hz and 450 Hz
/// (bending), 700 Hz (hoop). `more` is added to the spec.
acquire::Record struck_tube(const std::string& times_s, double duration_s, const std::string& more = "");

}  // namespace percuss::test
