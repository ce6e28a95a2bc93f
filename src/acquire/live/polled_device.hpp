#pragma once
#include <atomic>
#include <cstddef>
#include <span>
#include <thread>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// A device with its own thread, which polls it for frames. A derived class calls stop() in its destructor.
class PolledDevice : public Device {
 public:
  void start(FrameSink& sink) final;
  void stop() final;

 protected:
  /// Starts the device, before the thread polls it.
  /// errors  InputError: as Device::start
  virtual void prepare() {}
  /// Writes the next frames to the sink, and ends it after the last one. Waits for frames for about 0.1 s at most.
  /// Exceptions end the stream as failed.
  virtual void poll(FrameSink& sink) = 0;
  bool stopping() const { return stopping_.load(std::memory_order_relaxed); }
  /// Writes frames in parts, each as soon as the sink has room. Drops frames only if the device is being stopped.
  void write_with_room(FrameSink& sink, std::span<const std::byte> frames, std::size_t frame_bytes) const;
  /// Sleeps briefly, so that the sink can make room.
  static void wait_shortly();

 private:
  void run(FrameSink& sink);

  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace percuss::acquire
