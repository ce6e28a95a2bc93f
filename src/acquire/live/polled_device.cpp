#include "acquire/live/polled_device.hpp"

#include <chrono>
#include <exception>

namespace percuss::acquire {
namespace {

constexpr std::chrono::microseconds kWaitForRoom{300};

/// Passes everything on, and notes the end.
class NotingSink final : public FrameSink {
 public:
  explicit NotingSink(FrameSink& sink) : sink_(sink) {}
  void write(const void* frames, std::size_t count) noexcept override { sink_.write(frames, count); }
  void skip(std::uint64_t frames, bool overrun) noexcept override { sink_.skip(frames, overrun); }
  std::size_t room() const noexcept override { return sink_.room(); }
  void end(StreamEnd reason) noexcept override {
    ended_ = true;
    sink_.end(reason);
  }
  bool ended() const { return ended_; }

 private:
  FrameSink& sink_;
  bool ended_ = false;
};

}  // namespace

void PolledDevice::start(FrameSink& sink) {
  prepare();
  thread_ = std::thread([this, &sink] { run(sink); });
}

void PolledDevice::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

bool PolledDevice::wait_for_room(const FrameSink& sink, std::size_t frames) const {
  while (sink.room() < frames && !stopping()) std::this_thread::sleep_for(kWaitForRoom);
  return sink.room() >= frames;
}

void PolledDevice::run(FrameSink& sink) {
  NotingSink noting(sink);
  try {
    while (!stopping() && !noting.ended()) poll(noting);
    noting.end(StreamEnd::finished);
  } catch (const std::exception&) {
    noting.end(StreamEnd::failed);
  }
}

}  // namespace percuss::acquire
