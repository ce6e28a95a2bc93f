#include "pipeline/live/sample_history.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "acquire/record/sample_limits.hpp"

namespace percuss::pipeline {
namespace {

std::uint64_t end_of(const acquire::SampleBlock& block) { return block.first_frame + block.frames; }

// Removes the frames before `frame`.
void trim(acquire::SampleBlock& block, std::uint64_t frame, std::size_t channels) {
  if (block.first_frame >= frame) return;
  const std::size_t known = std::min<std::uint64_t>(block.frames, frame - block.first_frame);
  block.values.erase(block.values.begin(), block.values.begin() + static_cast<std::ptrdiff_t>(known * channels));
  block.frames -= known;
  block.first_frame += known;
}

}  // namespace

void SampleHistory::note_loss(const acquire::SampleBlock& block) {
  const std::uint64_t missing = block.first_frame - end_;
  if (missing > 0 || block.overrun) losses_.push_back({.frame = end_, .frames = missing, .overrun = block.overrun});
}

void SampleHistory::note_no_number(std::size_t channel, std::uint64_t frame) {
  std::deque<SampleLoss>& losses = no_numbers_[channel];
  if (!losses.empty() && losses.back().frame + losses.back().frames == frame) {
    ++losses.back().frames;
  } else {
    losses.push_back({.frame = frame, .frames = 1, .channel = channel});
  }
}

void SampleHistory::replace_unusable(acquire::SampleBlock& block) {
  for (std::size_t i = 0; i < block.frames; ++i) {
    for (std::size_t c = 0; c < channels_; ++c) {
      double& value = block.values[i * channels_ + c];
      if (std::abs(value) <= acquire::kMaxSample) {
        last_[c] = value;
        continue;
      }
      value = last_[c];
      note_no_number(c, block.first_frame + i);
    }
  }
}

void SampleHistory::add(acquire::SampleBlock block) {
  if (block.values.size() != block.frames * channels_)
    throw std::invalid_argument("a block of samples has another number of channels");
  if (blocks_.empty() && end_ == 0) {
    first_ = end_ = block.first_frame;
  }
  trim(block, end_, channels_);
  if (block.frames == 0) return;
  note_loss(block);
  replace_unusable(block);
  end_ = end_of(block);
  blocks_.push_back(std::move(block));
}

void SampleHistory::discard_before(std::uint64_t frame) {
  // The block before a loss stays, because a lost frame reads as the value before it.
  while (blocks_.size() > 1 && end_of(blocks_.front()) <= frame && blocks_[1].first_frame <= frame) {
    blocks_.pop_front();
    first_ = blocks_.front().first_frame;
  }
  const auto discard = [this](std::deque<SampleLoss>& losses) {
    while (!losses.empty() && losses.front().frame + losses.front().frames < first_) losses.pop_front();
  };
  discard(losses_);
  for (auto& losses : no_numbers_) discard(losses);
}

void SampleHistory::read(std::size_t channel, std::uint64_t first, std::span<double> out) const {
  auto block = std::upper_bound(blocks_.begin(), blocks_.end(), first,
                                [](std::uint64_t frame, const auto& other) { return frame < end_of(other); });
  double held = 0;
  if (block != blocks_.begin()) {
    const auto before = std::prev(block);
    held = before->values[(before->frames - 1) * channels_ + channel];
  }
  for (std::size_t i = 0; i < out.size();) {
    const std::uint64_t frame = first + i;
    while (block != blocks_.end() && end_of(*block) <= frame) ++block;
    if (block == blocks_.end() || frame < block->first_frame) {  // lost
      const std::uint64_t until = block == blocks_.end() ? first + out.size() : block->first_frame;
      const std::size_t count = std::min<std::uint64_t>(out.size() - i, until - frame);
      std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(i), count, held);
      i += count;
      continue;
    }
    const std::size_t at = frame - block->first_frame, count = std::min(out.size() - i, block->frames - at);
    for (std::size_t k = 0; k < count; ++k) out[i + k] = block->values[(at + k) * channels_ + channel];
    held = out[i + count - 1];
    i += count;
  }
}

std::vector<SampleLoss> SampleHistory::losses(std::uint64_t first, std::uint64_t last) const {
  std::vector<SampleLoss> out;
  const auto add = [&](const std::deque<SampleLoss>& losses) {
    std::copy_if(losses.begin(), losses.end(), std::back_inserter(out), [&](const SampleLoss& loss) {
      return loss.frame < last && loss.frame + std::max<std::uint64_t>(loss.frames, 1) > first;
    });
  };
  add(losses_);
  for (const auto& losses : no_numbers_) add(losses);
  std::stable_sort(out.begin(), out.end(), [](const SampleLoss& a, const SampleLoss& b) { return a.frame < b.frame; });
  return out;
}

}  // namespace percuss::pipeline
