#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live/sample_stream.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The numbers that a device delivers, in the byte order of the machine.
enum class SampleType { int32, float32, float64 };

constexpr std::size_t bytes_per_sample(SampleType type) { return type == SampleType::float64 ? 8 : 4; }

/// Who decides when the next frame comes: the device's clock, the capture's ring buffer (a pipe can wait until it has
/// room), or the reader of the stream (a replay that must lose nothing and that has time).
enum class DevicePace { clock, ring, reader };

/// The frames of a device: all its channels, before a choice of channels.
struct DeviceFormat {
  StreamFormat stream;
  SampleType type = SampleType::float32;
  double scale = 1;              // value in the units of `stream` = number × scale
  std::vector<double> scales{};  // [channels], where they differ; replaces `scale`
  DevicePace pace = DevicePace::clock;
  std::vector<ChannelSetup> setup{};  // [channels] roles and places, where the device has applied the user's set-up
  std::vector<Message> notes{};       // assumptions, such as units
};

/// Receives the frames of a running device. No member allocates, locks or waits: a real-time thread may call them.
class FrameSink {
 public:
  FrameSink() = default;
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;
  virtual ~FrameSink() = default;

  /// Takes `count` frames of the device's numbers, all channels interleaved. Frames without room are counted as lost.
  virtual void write(const void* frames, std::size_t count) noexcept = 0;
  /// States that the device lost `frames` frames here; 0 where it does not know how many. `overrun`: a buffer
  /// overflowed. A skip by StreamFormat::pause_frames without an overrun is the pause between two rows of a replay.
  virtual void skip(std::uint64_t frames, bool overrun) noexcept = 0;
  /// The frames that can be written now.
  virtual std::size_t room() const noexcept = 0;
  /// States that no frame will follow, and why. The first reason holds.
  virtual void end(StreamEnd reason) noexcept = 0;
};

/// An opened device. Frames arrive between start() and stop(), from one thread of the device.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  virtual const DeviceFormat& format() const = 0;
  /// errors  InputError: the device is busy, unplugged or does not start
  virtual void start(FrameSink& sink) = 0;
  /// Returns when no further frame will arrive. May be called twice.
  virtual void stop() = 0;
  /// A reason to end that the device cannot tell its sink, such as a callback that no longer comes. Called often.
  virtual StreamEnd check() { return StreamEnd::none; }
};

/// What the user asks of a device.
struct DeviceOptions {
  std::optional<double> fs_Hz;          // absent: the device's own rate
  std::optional<std::size_t> channels;  // open at least so many; a device that always delivers all ignores it
  bool fast = false;                    // a simulated or replayed device need not keep to real time
  std::uint64_t start_frame = 0;        // simulated and replayed devices begin here: where a session was interrupted
  std::vector<ChannelSetup> setup{};    // the user's: open_file_device and open_pipe_device say what it changes
};

/// For samples whose rate nobody can choose.
/// errors  InputError at `where`: the options state another rate than fs_Hz
void require_rate(double fs_Hz, const DeviceOptions& options, const std::string& where);

}  // namespace percuss::acquire
