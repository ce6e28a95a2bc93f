#include "acquire/live/sample_store.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace percuss::acquire {
namespace {

constexpr double kMaxRing_bytes = 32.0 * 1024 * 1024;
constexpr std::size_t kMinRing = 1024;  // frames
// Frames, for low rates, where StoreOptions::ring_s holds few frames. Limited by kMaxRing_bytes.
constexpr std::size_t kMinSlowRing = 8192;
// At least as many frames as the search for blows examines at once, at any sampling rate.
constexpr std::size_t kTakenTogether = 1024;
constexpr std::size_t kMaxBlock_bytes = std::size_t{4} << 20U;
constexpr std::size_t kMaxFindings = 10000;  // kept until they are taken
constexpr double kDriftLimit = 200e-6;       // crystals keep to 100 ppm
constexpr double kSigmas = 5;

std::size_t frames_in(double seconds, double fs_Hz) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(seconds * fs_Hz)));
}

std::size_t ring_frames(const FrameLayout& layout, const StreamFormat& format, double ring_s) {
  const auto frame_bytes = static_cast<double>(bytes_per_sample(layout.type) * layout.channels.size());
  const double seconds = std::min(ring_s, kMaxRing_bytes / (frame_bytes * format.fs_Hz));
  const std::size_t fitting = std::min(kMinSlowRing, static_cast<std::size_t>(kMaxRing_bytes / frame_bytes));
  return std::max({frames_in(seconds, format.fs_Hz), fitting, kMinRing});
}

std::size_t block_frames(const StreamFormat& format, double block_s) {
  const std::size_t most = std::max<std::size_t>(1, kMaxBlock_bytes / (sizeof(double) * format.channels));
  return std::min(frames_in(block_s, format.fs_Hz), most);
}

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

SampleStore::SampleStore(const FrameLayout& layout, const StreamFormat& format, DevicePace pace,
                         std::unique_ptr<SessionJournal> journal, const StoreOptions& options)
    : format_(format),
      pace_(pace),
      block_frames_(block_frames(format, options.block_s)),
      ring_(layout, ring_frames(layout, format, options.ring_s), journal ? journal->writer().next_frame() : 0),
      history_frames_(std::min(frames_in(options.history_s, format.fs_Hz) + kTakenTogether, ring_.capacity() / 2)),
      journal_(std::move(journal)),
      expected_frame_(journal_ ? journal_->writer().next_frame() : 0),
      inspection_(format),
      drift_(format.fs_Hz) {}

bool SampleStore::pump() {
  const bool inspected = inspect();
  bool wrote = false;
  while (write_block(false)) wrote = true;
  if (journal_) watch_journal();
  make_room();
  return inspected || wrote;
}

void SampleStore::finish() {
  inspect();
  if (const std::uint64_t dropped = ring_.dropped() - known_dropped_; dropped > 0)  // after the last frame
    note({.fault = CaptureFault::dropped, .frame = expected_frame_, .count = dropped});
  found_.clear();
  inspection_.finish(found_);
  for (CaptureFinding& finding : std::exchange(found_, {})) note(std::move(finding));
  note_drift();
  const StreamEnd end = ring_.ended();
  if (end == StreamEnd::unplugged) note({.fault = CaptureFault::unplugged, .frame = expected_frame_});
  if (end == StreamEnd::rate_changed) note({.fault = CaptureFault::rate_changed, .frame = expected_frame_});
  if (end == StreamEnd::failed) note({.fault = CaptureFault::failed, .frame = expected_frame_});
}

void SampleStore::close_journal() {
  if (!journal_) return;
  write_rest();
  journal_->flush();
  journal_->sync();
  watch_journal();
}

// A full disk gets one more attempt. A finding states the frames that are still missing then.
void SampleStore::write_rest() {
  const auto write = [this] {
    while (write_block(true)) {
    }
  };
  write();
  journal_->wait_for_retry();
  write();
  std::uint64_t lost = 0;
  {
    const std::lock_guard guard(mutex_);
    lost = std::exchange(lost_by_journal_, 0) + (begun_ ? ring_.written() - written_ : 0);
  }
  if (lost > 0) note({.fault = CaptureFault::not_in_journal, .frame = expected_frame_, .count = lost});
}

bool SampleStore::inspect() {
  bool any = false;
  for (;;) {
    RingRange range;
    {
      const std::lock_guard guard(mutex_);
      inspected_ = std::max(inspected_, ring_.released());
      range = ring_.range_from(inspected_, block_frames_);
    }
    if (range.frames == 0) return any;
    any = true;
    // At a loss or a pause, the count of frames does not show the time that has passed.
    const bool jumps = range.overrun || format_.is_pause(range.first_frame - expected_frame_, range.overrun);
    inspect_range(range);
    inspected_ += range.frames;
    expected_frame_ = range.first_frame + range.frames;
    if (jumps) drift_ = ClockDrift(format_.fs_Hz);
    if (pace_ == DevicePace::clock) drift_.add(expected_frame_, now_s());
  }
}

void SampleStore::inspect_range(const RingRange& range) {
  values_.resize(range.frames * format_.channels);
  ring_.read(range.index, values_);
  if (range.overrun || range.first_frame != expected_frame_) note_loss(range);
  found_.clear();
  inspection_.add(range.first_frame, values_, found_);
  for (CaptureFinding& finding : std::exchange(found_, {})) note(std::move(finding));
}

void SampleStore::note_loss(const RingRange& range) {
  const std::uint64_t lost = range.first_frame - expected_frame_;
  if (format_.is_pause(lost, range.overrun)) return;
  const std::uint64_t dropped = ring_.dropped() - std::exchange(known_dropped_, ring_.dropped());
  CaptureFault fault = range.overrun ? CaptureFault::overrun : CaptureFault::gap;
  if (dropped > 0) fault = CaptureFault::dropped;
  note({.fault = fault, .frame = range.first_frame, .count = lost});
}

void SampleStore::note(CaptureFinding finding) {
  if (journal_) journal_->append_text(journal_block(JournalBlockType::finding, finding_json(finding), finding.frame));
  const std::lock_guard guard(mutex_);
  if (findings_.size() < kMaxFindings) findings_.push_back(std::move(finding));
}

void SampleStore::note_drift() {
  const auto drift = drift_.estimate();
  if (!drift || std::abs(drift->relative) < kDriftLimit + kSigmas * drift->standard_deviation) return;
  note({.fault = CaptureFault::clock_drift, .frame = expected_frame_, .value = drift->relative});
}

void SampleStore::begin_at(std::uint64_t index) {
  begun_ = true;
  written_ = std::max(index, ring_.released());
}

bool SampleStore::write_block(bool last) {
  RingRange range;
  {
    const std::lock_guard guard(mutex_);
    if (!begun_) return false;
    range = ring_.range_from(written_, block_frames_);
    const bool may_grow = range.index + range.frames == ring_.written() && range.frames < block_frames_;
    if (range.frames == 0 || (may_grow && !last)) return false;
  }
  block_.first_frame = range.first_frame;
  block_.frames = range.frames;
  block_.overrun = range.overrun;
  block_.values.resize(range.frames * format_.channels);
  ring_.read(range.index, block_.values);
  make_sample_block(block_, format_.channels, block_bytes_);
  const auto offset = journal_->append_samples(block_bytes_);
  if (!offset) return false;
  std::uint64_t lost = 0;
  {
    const std::lock_guard guard(mutex_);
    written_ += range.frames;
    lost = std::exchange(lost_by_journal_, 0);
    if (written_ > read_)
      unread_.push_back({range.index, range.first_frame, *offset, range.frames, block_bytes_.size()});
  }
  if (lost > 0) note({.fault = CaptureFault::not_in_journal, .frame = range.first_frame, .count = lost});
  return true;
}

void SampleStore::watch_journal() {
  journal_->flush();
  const std::string fault = journal_->fault();
  if (!fault.empty() && !fault_noted_)
    note({.fault = CaptureFault::journal_failed, .frame = expected_frame_, .text = fault});
  fault_noted_ = !fault.empty();
}

// The ring keeps the frames that the reader or the journal still needs. When the reader lags by more than half of the
// ring, it gets the older frames from the journal. When the ring is nearly full nevertheless, the oldest frames are
// lost, and counted.
void SampleStore::make_room() {
  std::uint64_t lost_by_reader = 0;
  std::uint64_t frame = 0;
  {
    const std::lock_guard guard(mutex_);
    const std::uint64_t head = ring_.written(), half = ring_.capacity() / 2;
    const std::uint64_t lag = head - read_;
    if (journal_ && !begun_ && lag > half) begin_at(ring_.released());
    // The history ends where the reader is: a device without a clock may be far ahead of it.
    std::uint64_t done = begun_ ? written_ : journal_ ? read_ - std::min<std::uint64_t>(read_, history_frames_) : head;
    done = std::min(done, inspected_);
    std::uint64_t release = std::min(done, read_);
    if (begun_ && pace_ != DevicePace::reader && lag > half) release = std::min(done, head - half);
    const std::uint64_t full = ring_.capacity() - ring_.capacity() / 8;
    if (pace_ == DevicePace::clock && head - release > full) {
      release = head - full;
      const std::uint64_t kept = std::max({read_, begun_ ? written_ : 0, ring_.released()});
      lost_by_reader = release - std::min(release, kept);
    }
    // A device without a clock waits for the journal, but not for a full disk.
    if (begun_ && pace_ != DevicePace::clock && head - release > full && !journal_->fault().empty())
      release = std::max(release, std::min(read_, head - full));
    if (begun_ && release > written_) {
      lost_by_journal_ += release - written_;
      written_ = release;
    }
    if (lost_by_reader > 0) {
      lost_by_reader_ += lost_by_reader;
      frame = ring_.range_from(release, 1).first_frame;
    }
    ring_.release(std::max(release, ring_.released()));
  }
  if (lost_by_reader > 0) note({.fault = CaptureFault::dropped, .frame = frame, .count = lost_by_reader});
}

}  // namespace percuss::acquire
