#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live/capture_finding.hpp"
#include "acquire/live/clock_drift.hpp"
#include "acquire/live/frame_ring.hpp"
#include "acquire/live/sample_inspection.hpp"
#include "acquire/live/session_journal.hpp"

namespace percuss::acquire {

struct StoreOptions {
  double history_s = 2;  // kept in memory until the journal begins
  double ring_s = 12;    // of frames in memory; less where they need more than 32 MiB
  double block_s = 0.1;  // of samples in a block of the journal
};

/// How a capture stands; for tests.
struct CaptureState {
  std::uint64_t journal_bytes = 0;   // length of the journal
  std::uint64_t unread_frames = 0;   // captured, and not yet read by the analysis
  std::uint64_t dropped_frames = 0;  // lost by percuss
  std::string journal_fault{};       // why the journal cannot be written now; empty: it can
};

/// Frames on their way from a device to the reader: in a ring in memory, and in the journal. Three threads use it: the
/// device's (sink), the writer's (pump, finish, close_journal) and the reader's (the others).
class SampleStore {
 public:
  /// Without a journal, a reader that stalls longer than the ring lasts loses frames.
  SampleStore(const FrameLayout& layout, const StreamFormat& format, DevicePace pace,
              std::unique_ptr<SessionJournal> journal, const StoreOptions& options);

  FrameSink& sink() { return ring_; }
  StreamEnd ended() const { return ring_.ended(); }

  /// Inspects new frames, writes full blocks to the journal, and frees room in the ring. Whether there was work.
  bool pump();
  /// Notes the findings that only the end of the stream shows. Precondition: the device writes no more frames. pump()
  /// may follow.
  void finish();
  /// Writes what the journal still lacks. Nothing may follow.
  void close_journal();

  /// The next block, at most `block_s` long; nothing if there is none now.
  std::optional<SampleBlock> take();
  bool everything_taken();
  /// Begins the journal at a frame, or at the oldest one in memory.
  void keep_from(std::uint64_t frame);
  void append_event(const std::string& json);
  std::vector<CaptureFinding> take_findings();
  CaptureState state();

 private:
  struct UnreadBlock {  // in the journal
    std::uint64_t index = 0, first_frame = 0, offset = 0;
    std::size_t frames = 0, bytes = 0;
  };

  bool inspect();
  void inspect_range(const RingRange& range);
  void note_loss(const RingRange& range);
  void note(CaptureFinding finding);
  void note_drift();
  bool write_block(bool last);
  void write_rest();
  void watch_journal();
  void begin_at(std::uint64_t index);
  void make_room();
  std::optional<SampleBlock> take_from_journal(std::unique_lock<std::mutex>& lock);

  const StreamFormat format_;
  const DevicePace pace_;
  const std::size_t block_frames_;
  FrameRing ring_;
  const std::size_t history_frames_;
  std::unique_ptr<SessionJournal> journal_;

  std::mutex mutex_;  // guards the consumer's side of the ring, and the members up to the blank line
  std::uint64_t read_ = 0, written_ = 0;  // index of the next frame for the reader, for the journal
  bool begun_ = false;
  std::uint64_t lost_by_reader_ = 0, lost_by_journal_ = 0;
  bool overrun_for_reader_ = false;
  std::deque<UnreadBlock> unread_;
  std::vector<CaptureFinding> findings_;

  // The writer's own.
  std::uint64_t inspected_ = 0, expected_frame_ = 0, known_dropped_ = 0;
  SampleInspection inspection_;
  ClockDrift drift_;
  std::vector<double> values_;
  std::vector<CaptureFinding> found_;
  SampleBlock block_;
  std::string block_bytes_;
  bool fault_noted_ = false;
};

}  // namespace percuss::acquire
