#include "acquire/live/polled_device.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

namespace percuss::acquire {
namespace {

constexpr std::chrono::microseconds kWaitForRoom{300};

// Passes everything on, and notes the end.
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

void PolledDevice::wait_shortly() { std::this_thread::sleep_for(kWaitForRoom); }

void PolledDevice::write_with_room(FrameSink& sink, std::span<const std::byte> frames, std::size_t frame_bytes) const {
  while (!frames.empty() && !stopping()) {
    const std::size_t count = std::min(sink.room(), frames.size() / frame_bytes);
    if (count == 0) {
      wait_shortly();
      continue;
    }
    sink.write(frames.data(), count);
    frames = frames.subspan(count * frame_bytes);
  }
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
