#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "acquire/live/sample_stream.hpp"

namespace percuss::pipeline {

/// Frames that a stream lost, or samples of one channel that are no numbers.
struct SampleLoss {
  std::uint64_t frame = 0;               // the first one
  std::uint64_t frames = 0;              // 0: the device stated an overrun, but its count of frames goes on
  bool overrun = false;                  // stated by the device
  std::optional<std::size_t> channel{};  // whose samples are NaN, infinite or above kMaxSample; nothing: lost frames
};

/// The recent samples of a stream, addressed by frame. A lost frame, and a sample that is no number (NaN, infinite or
/// above acquire::kMaxSample), read as the last value before it; losses() tells where.
class SampleHistory {
 public:
  explicit SampleHistory(std::size_t channels) : channels_(channels), no_numbers_(channels), last_(channels) {}

  /// Appends a block. Frames that are known already are ignored.
  /// errors  std::invalid_argument: the block has another number of channels.
  void add(acquire::SampleBlock block);
  /// Forgets older frames, block by block.
  void discard_before(std::uint64_t frame);

  std::uint64_t first_frame() const { return first_; }
  std::uint64_t end_frame() const { return end_; }
  /// Frames first … first + out.size() − 1 of a channel, which must lie within the history.
  void read(std::size_t channel, std::uint64_t first, std::span<double> out) const;
  /// The losses that touch the frames first … last − 1, ascending. Samples without a number that follow one another are
  /// one loss, whatever the blocks.
  std::vector<SampleLoss> losses(std::uint64_t first, std::uint64_t last) const;

 private:
  void note_loss(const acquire::SampleBlock& block);
  void note_no_number(std::size_t channel, std::uint64_t frame);
  void replace_unusable(acquire::SampleBlock& block);

  std::size_t channels_;
  std::uint64_t first_ = 0, end_ = 0;
  std::deque<acquire::SampleBlock> blocks_;
  std::deque<SampleLoss> losses_;                   // of frames
  std::vector<std::deque<SampleLoss>> no_numbers_;  // [channels]
  std::vector<double> last_;                        // [channels], of the newest frame
};

}  // namespace percuss::pipeline
