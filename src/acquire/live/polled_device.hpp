#pragma once
#include <atomic>
#include <thread>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// A device that is asked for its frames by a thread of its own. A derived class calls stop() in its destructor.
class PolledDevice : public Device {
 public:
  void start(FrameSink& sink) final;
  void stop() final;

 protected:
  /// Starts the frames. errors  InputError
  virtual void prepare() {}
  /// Writes the next frames to the sink, and ends it after the last one. Waits for frames for about 0.1 s at most.
  /// Exceptions end the stream as failed.
  virtual void poll(FrameSink& sink) = 0;
  bool stopping() const { return stopping_.load(std::memory_order_relaxed); }
  /// Waits until the sink has room for `frames`, or until the device shall stop. Whether there is room.
  bool wait_for_room(const FrameSink& sink, std::size_t frames) const;

 private:
  void run(FrameSink& sink);

  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace percuss::acquire
