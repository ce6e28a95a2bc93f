#include <algorithm>
#include <utility>

#include "acquire/live/sample_store.hpp"

namespace percuss::acquire {

std::optional<SampleBlock> SampleStore::take() {
  std::unique_lock lock(mutex_);
  if (read_ < ring_.released()) {
    if (auto block = take_from_journal(lock)) return block;
  }
  const RingRange range = ring_.range_from(read_, block_frames_);
  if (range.frames == 0) return {};
  SampleBlock block{.first_frame = range.first_frame,
                    .frames = range.frames,
                    .values = std::vector<double>(range.frames * format_.channels),
                    .overrun = range.overrun || std::exchange(overrun_for_reader_, false)};
  ring_.read(range.index, block.values);
  read_ += range.frames;
  while (!unread_.empty() && unread_.front().index + unread_.front().frames <= read_) unread_.pop_front();
  return block;
}

// Nothing where the journal has no frame before those in the ring; the reader then goes on with the ring.
std::optional<SampleBlock> SampleStore::take_from_journal(std::unique_lock<std::mutex>& lock) {
  while (read_ < ring_.released()) {
    while (!unread_.empty() && unread_.front().index + unread_.front().frames <= read_) unread_.pop_front();
    const std::uint64_t next = unread_.empty() ? ring_.released() : std::min(unread_.front().index, ring_.released());
    if (next > read_) {
      read_ = next;
      overrun_for_reader_ = true;
      continue;
    }
    const UnreadBlock place = unread_.front();
    unread_.pop_front();
    const auto skipped = static_cast<std::size_t>(read_ - place.index);  // only this thread changes read_
    lock.unlock();
    const std::string bytes = journal_->writer().block_at(place.offset, place.bytes);
    const std::string_view head(bytes.data(), std::min(bytes.size(), kBlockHeader_bytes));
    const std::string_view payload = std::string_view(bytes).substr(head.size());
    const auto header = parse_block_header(head);
    const bool whole = header && block_is_whole(head, payload);
    if (!whole) {
      note(
          {.fault = CaptureFault::dropped, .frame = place.first_frame + place.frames, .count = place.frames - skipped});
    }
    SampleBlock block;
    if (whole) {
      block = {.first_frame = header->first_frame,
               .frames = place.frames,
               .values = block_values(*header, payload),
               .overrun = (header->flags & kBlockOverrun) != 0};
    }
    lock.lock();
    read_ = place.index + place.frames;
    if (!whole) {
      overrun_for_reader_ = true;
      continue;
    }
    block.values.erase(block.values.begin(),
                       block.values.begin() + static_cast<std::ptrdiff_t>(skipped * format_.channels));
    block.first_frame += skipped;
    block.frames -= skipped;
    block.overrun = (block.overrun && skipped == 0) || std::exchange(overrun_for_reader_, false);
    return block;
  }
  return {};
}

bool SampleStore::everything_taken() {
  const std::lock_guard guard(mutex_);
  return read_ >= ring_.written();
}

void SampleStore::keep_from(std::uint64_t frame) {
  const std::lock_guard guard(mutex_);
  if (!journal_ || begun_) return;
  const std::uint64_t oldest = ring_.range_from(ring_.released(), 1).first_frame;
  if (ring_.released() > 0 && oldest > frame) lost_by_journal_ += oldest - frame;
  begin_at(ring_.index_of(frame));
}

void SampleStore::append_event(const std::string& json) {
  if (journal_) journal_->append_text(journal_block(JournalBlockType::event, json));
}

std::vector<CaptureFinding> SampleStore::take_findings() {
  const std::lock_guard guard(mutex_);
  return std::exchange(findings_, {});
}

CaptureState SampleStore::state() {
  CaptureState state;
  if (journal_) {
    state.journal_bytes = journal_->writer().size_bytes();
    state.journal_fault = journal_->fault();
  }
  const std::lock_guard guard(mutex_);
  state.unread_frames = ring_.written() - read_;
  state.dropped_frames = ring_.dropped() + lost_by_reader_;
  return state;
}

}  // namespace percuss::acquire
