#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace percuss::acquire {

/// What a device delivers: the meaning of its samples.
struct StreamFormat {
  std::string device;  // for people: "sim:aluminium-bat", "USB Audio CODEC"
  double fs_Hz = 0;
  std::size_t channels = 0;
  std::vector<std::string> names;      // [channels]; may be empty
  std::vector<std::string> units;      // [channels], of the delivered numbers: "V", "N", "m/s^2"; empty: none is stated
  double full_scale = 0;               // the largest |value| that the device can deliver; 0: not known
  std::vector<double> full_scales;     // [channels], where they differ; `full_scale` is then the first channel's
  std::vector<std::size_t> numbers{};  // [channels], of the device, from 1; empty: 1, 2, …
  std::uint64_t pause_frames = 0;      // from row to row of a replayed record; no frame exists there

  /// The device's number of a channel, for people.
  std::size_t number_of(std::size_t channel) const { return numbers.empty() ? channel + 1 : numbers.at(channel); }
  /// Whether a jump by so many frames is the pause between two rows, and no loss.
  bool is_pause(std::uint64_t frames, bool overrun) const { return !overrun && frames > 0 && frames == pause_frames; }
};

/// Consecutive frames of all channels, in the order of their capture. A frame has one sample per channel.
struct SampleBlock {
  std::uint64_t first_frame = 0;  // by the device's count since its start; a jump is a loss or a pause
  std::size_t frames = 0;
  std::vector<double> values;  // [frames × channels], interleaved
  bool overrun = false;        // a buffer of the device or of percuss overflowed before this block
};

enum class StreamEnd { none, finished, unplugged, rate_changed, failed };

/// The samples of a running device, for the thread that analyses. Blocks arrive in order, each once. With a journal
/// on a disk that has room, the stream keeps all samples while the reader stalls.
class SampleStream {
 public:
  SampleStream() = default;
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;
  virtual ~SampleStream() = default;

  virtual const StreamFormat& format() const = 0;
  /// The next block; nothing if none arrives within `patience`, or after the end.
  virtual std::optional<SampleBlock> next(std::chrono::milliseconds patience) = 0;
  /// Why no further block will come; `none` while blocks may come.
  virtual StreamEnd end() const = 0;
  /// Ends the capture. Blocks that were captured can still be read.
  virtual void stop() = 0;
};

/// The part of the journal that the recording session writes and, on resuming, reads again.
class SessionLog {
 public:
  SessionLog() = default;
  SessionLog(const SessionLog&) = delete;
  SessionLog& operator=(const SessionLog&) = delete;
  virtual ~SessionLog() = default;

  /// Appends one event, a JSON text: a verdict, a key, a point. It survives a kill at any later moment, unless the disk
  /// is full.
  virtual void append_event(const std::string& json) = 0;
};

}  // namespace percuss::acquire
