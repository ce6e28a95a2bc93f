#include "acquire/live/frame_ring.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace percuss::acquire {
namespace {

template <class Number>
void read_numbers(const std::byte* from, const std::vector<double>& scales, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    Number number;
    std::memcpy(&number, from, sizeof number);
    out[i] = static_cast<double>(number) * scales[i % scales.size()];
    from += sizeof number;
  }
}

// Whether all channels are kept, in the order of the device.
bool keeps_frames(const FrameLayout& layout) {
  if (layout.channels.size() != layout.device_channels) return false;
  for (std::size_t c = 0; c < layout.channels.size(); ++c) {
    if (layout.channels[c] != c) return false;
  }
  return true;
}

}  // namespace

FrameRing::FrameRing(FrameLayout layout, std::size_t capacity_frames, std::uint64_t first_frame)
    : layout_(std::move(layout)),
      capacity_(std::max<std::size_t>(capacity_frames, 1)),
      sample_bytes_(bytes_per_sample(layout_.type)),
      frame_bytes_(sample_bytes_ * layout_.channels.size()),
      whole_frames_(keeps_frames(layout_)),
      bytes_(capacity_ * frame_bytes_),
      offsets_{{0, first_frame, false}} {}

std::size_t FrameRing::room() const noexcept {
  const std::uint64_t used = head_.load(std::memory_order_relaxed) - tail_.load(std::memory_order_acquire);
  return capacity_ - static_cast<std::size_t>(used);
}

// A loss goes to the consumer before the first frame after it.
bool FrameRing::pass_on_loss() noexcept {
  if (pending_lost_ == 0 && !pending_overrun_) return true;
  const std::uint64_t at = jump_head_.load(std::memory_order_relaxed);
  if (at - jump_tail_.load(std::memory_order_acquire) == kMaxJumps) return false;
  jumps_[at % kMaxJumps] = {head_.load(std::memory_order_relaxed), pending_lost_, pending_overrun_};
  jump_head_.store(at + 1, std::memory_order_release);
  pending_lost_ = 0;
  pending_overrun_ = false;
  return true;
}

void FrameRing::copy_in(const std::byte* frames, std::uint64_t index, std::size_t count) noexcept {
  for (std::size_t done = 0; done < count;) {
    const auto place = static_cast<std::size_t>((index + done) % capacity_);
    const std::size_t part = std::min(count - done, capacity_ - place);
    std::byte* to = bytes_.data() + place * frame_bytes_;
    const std::byte* from = frames + done * layout_.device_channels * sample_bytes_;
    if (whole_frames_) {
      std::memcpy(to, from, part * frame_bytes_);
    } else {
      for (std::size_t i = 0; i < part; ++i, from += layout_.device_channels * sample_bytes_) {
        for (const std::size_t channel : layout_.channels) {
          std::memcpy(to, from + channel * sample_bytes_, sample_bytes_);
          to += sample_bytes_;
        }
      }
    }
    done += part;
  }
}

void FrameRing::write(const void* frames, std::size_t count) noexcept {
  const std::size_t free = room();
  const std::size_t fitting = free > 0 && pass_on_loss() ? std::min(count, free) : 0;
  const std::uint64_t head = head_.load(std::memory_order_relaxed);
  copy_in(static_cast<const std::byte*>(frames), head, fitting);
  head_.store(head + fitting, std::memory_order_release);
  if (fitting == count) return;
  pending_lost_ += count - fitting;
  pending_overrun_ = true;
  dropped_.fetch_add(count - fitting, std::memory_order_relaxed);
}

void FrameRing::skip(std::uint64_t frames, bool overrun) noexcept {
  pending_lost_ += frames;
  pending_overrun_ = pending_overrun_ || overrun;
  pass_on_loss();
}

void FrameRing::end(StreamEnd reason) noexcept {
  StreamEnd none = StreamEnd::none;
  end_.compare_exchange_strong(none, reason, std::memory_order_acq_rel);
}

void FrameRing::collect_jumps() {
  std::uint64_t at = jump_tail_.load(std::memory_order_relaxed);
  for (const std::uint64_t last = jump_head_.load(std::memory_order_acquire); at < last; ++at) {
    const Jump& jump = jumps_[at % kMaxJumps];
    const std::uint64_t offset = offsets_.back().offset + jump.lost;
    if (offsets_.back().index == jump.index) {
      offsets_.back().offset = offset;
      offsets_.back().overrun = offsets_.back().overrun || jump.overrun;
    } else {
      offsets_.push_back({jump.index, offset, jump.overrun});
    }
  }
  jump_tail_.store(at, std::memory_order_release);
}

RingRange FrameRing::range_from(std::uint64_t index, std::size_t limit) {
  const std::uint64_t head = written();  // read first: collect_jumps() then finds every loss before these frames
  collect_jumps();
  const auto after = std::upper_bound(offsets_.begin(), offsets_.end(), index,
                                      [](std::uint64_t at, const Offset& offset) { return at < offset.index; });
  const Offset& own = *std::prev(after);
  const std::uint64_t last = after == offsets_.end() ? head : std::min(head, after->index);
  return {.index = index,
          .frames = static_cast<std::size_t>(std::min<std::uint64_t>(last - index, limit)),
          .first_frame = index + own.offset,
          .overrun = own.overrun && own.index == index};
}

std::uint64_t FrameRing::index_of(std::uint64_t frame) {
  const std::uint64_t head = written();
  collect_jumps();
  const auto after =
      std::upper_bound(offsets_.begin(), offsets_.end(), frame,
                       [](std::uint64_t at, const Offset& offset) { return at < offset.index + offset.offset; });
  if (after == offsets_.begin()) return released();
  const std::uint64_t last = after == offsets_.end() ? head : std::min(head, after->index);
  return std::clamp(frame - std::prev(after)->offset, released(), std::max(last, released()));
}

void FrameRing::read(std::uint64_t index, std::span<double> out) const {
  const std::size_t channels = layout_.channels.size();
  for (std::size_t done = 0; done < out.size();) {
    const auto place = static_cast<std::size_t>(index % capacity_);
    const std::size_t part = std::min(out.size() / channels - done / channels, capacity_ - place);
    const std::byte* from = bytes_.data() + place * frame_bytes_;
    const auto to = out.subspan(done, part * channels);
    if (layout_.type == SampleType::int32) read_numbers<std::int32_t>(from, layout_.scales, to);
    if (layout_.type == SampleType::float32) read_numbers<float>(from, layout_.scales, to);
    if (layout_.type == SampleType::float64) read_numbers<double>(from, layout_.scales, to);
    done += to.size();
    index += part;
  }
}

void FrameRing::release(std::uint64_t index) {
  while (offsets_.size() > 1 && offsets_[1].index < index) offsets_.pop_front();
  tail_.store(index, std::memory_order_release);
}

}  // namespace percuss::acquire
