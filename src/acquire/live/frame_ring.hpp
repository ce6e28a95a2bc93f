#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "acquire/live/device.hpp"

namespace percuss::acquire {

/// The frames of a device and the channels of it that are kept.
struct FrameLayout {
  SampleType type = SampleType::float32;
  std::size_t device_channels = 0;
  std::vector<std::size_t> channels;  // kept, by their number in the device from 0
  std::vector<double> scales;         // [channels]: value = number × scale
};

/// Consecutive frames in the ring. The index counts the frames that the ring took. The frame number also counts lost
/// frames.
struct RingRange {
  std::uint64_t index = 0;
  std::size_t frames = 0;
  std::uint64_t first_frame = 0;
  bool overrun = false;  // just before the first frame, a buffer of the device or this ring overflowed
};

/// A ring of frames between one producer, which calls the members of FrameSink, and one consumer, which calls the
/// others. It keeps the device's numbers and has no locks; the producer's members allocate nothing. When it is full,
/// the producer drops and counts. Several threads may act as the consumer if they exclude one another; read() needs no
/// exclusion as long as nobody releases its frames.
class FrameRing final : public FrameSink {
 public:
  /// Frame numbers begin at `first_frame`.
  FrameRing(FrameLayout layout, std::size_t capacity_frames, std::uint64_t first_frame = 0);

  // The producer.
  void write(const void* frames, std::size_t count) noexcept override;
  void skip(std::uint64_t frames, bool overrun) noexcept override;
  std::size_t room() const noexcept override;
  void end(StreamEnd reason) noexcept override;

  // The consumer.
  std::size_t capacity() const { return capacity_; }
  std::uint64_t written() const { return head_.load(std::memory_order_acquire); }
  std::uint64_t released() const { return tail_.load(std::memory_order_relaxed); }
  /// Frames that found no room.
  std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
  StreamEnd ended() const { return end_.load(std::memory_order_acquire); }
  /// The frames from `index` to the next loss, or to the newest frame; at most `limit`.
  RingRange range_from(std::uint64_t index, std::size_t limit);
  /// The index of the frame with this number. For a frame that is not in the ring, the index of the next one that is.
  std::uint64_t index_of(std::uint64_t frame);
  /// Frames index … index + out.size()/channels − 1 as values in the stream's units, interleaved.
  void read(std::uint64_t index, std::span<double> out) const;
  /// Gives the frames before `index` back to the producer.
  void release(std::uint64_t index);

 private:
  static constexpr std::size_t kMaxJumps = 256;  // losses that the consumer has not seen yet

  struct Jump {
    std::uint64_t index = 0;  // of the first frame after the loss
    std::uint64_t lost = 0;
    bool overrun = false;
  };
  struct Offset {
    std::uint64_t index = 0;
    std::uint64_t offset = 0;  // frame number − index, from this index on
    bool overrun = false;
  };

  bool pass_on_loss() noexcept;
  void copy_in(const std::byte* frames, std::uint64_t index, std::size_t count) noexcept;
  void collect_jumps();

  const FrameLayout layout_;
  const std::size_t capacity_, sample_bytes_, frame_bytes_;
  const bool whole_frames_;
  std::vector<std::byte> bytes_;
  std::atomic<std::uint64_t> head_{0}, tail_{0}, dropped_{0};
  std::atomic<StreamEnd> end_{StreamEnd::none};
  std::array<Jump, kMaxJumps> jumps_{};
  std::atomic<std::uint64_t> jump_head_{0}, jump_tail_{0};
  std::uint64_t pending_lost_ = 0;  // the producer's
  bool pending_overrun_ = false;
  std::deque<Offset> offsets_;  // the consumer's
};

}  // namespace percuss::acquire
