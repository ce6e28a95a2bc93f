#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/journal_reader.hpp"
#include "support/scratch_folder.hpp"
#include "synth/simulated_device.hpp"

namespace percuss::acquire::full_disk_test {

// Speed of the simulated device, in multiples of real time. Sanitizers make it slower.
#ifdef PERCUSS_SANITIZED
#define PERCUSS_DISK_SPEED "2"
#else
#define PERCUSS_DISK_SPEED "4"
#endif

using namespace std::chrono_literals;
using test::ScratchFolder;

/// Files of this process cannot grow beyond a limit: a write beyond it fails as on a full disk.
class FileLimit {
 public:
  FileLimit() : old_signal_(std::signal(SIGXFSZ, SIG_IGN)) { ::getrlimit(RLIMIT_FSIZE, &old_); }
  ~FileLimit() {
    lift();
    std::signal(SIGXFSZ, old_signal_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  void set(rlim_t bytes) const {
    const rlimit limit{.rlim_cur = bytes, .rlim_max = old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  void lift() const { ::setrlimit(RLIMIT_FSIZE, &old_); }

 private:
  rlimit old_{};
  void (*old_signal_)(int);
};

std::uint64_t gaps_until(CaptureStream& stream, std::uint64_t until, std::uint64_t& next) {
  std::uint64_t jumps = 0;
  while (next < until && stream.end() == StreamEnd::none) {
    const auto block = stream.next(100ms);
    if (!block) continue;
    if (block->first_frame != next) ++jumps;
    next = block->first_frame + block->frames;
  }
  return jumps;
}

std::vector<CaptureFault> faults(const std::vector<CaptureFinding>& findings) {
  std::vector<CaptureFault> out;
  out.reserve(findings.size());
  for (const CaptureFinding& finding : findings) out.push_back(finding.fault);
  return out;
}

constexpr std::uint64_t kSecond = 25600;  // in frames
const StoreOptions kStore{.ring_s = 8};

// The disk is full for less time than the ring buffer holds: neither the reader nor the journal loses a frame.
TEST(FullDisk, IsSurvivedByTheRing) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.journal");
  const FileLimit limit;
  CaptureStream stream(synth::open_simulated_device("wood-bat,hits=5,end=16,speed=" PERCUSS_DISK_SPEED),
                       {.journal = path, .store = kStore});
  stream.keep_from(0);
  std::uint64_t next = 0;
  EXPECT_EQ(gaps_until(stream, 3 * kSecond, next), 0U);
  limit.set(stream.state().journal_bytes + 5000);
  EXPECT_EQ(gaps_until(stream, 8 * kSecond, next), 0U);
  EXPECT_FALSE(stream.state().journal_fault.empty());
  EXPECT_EQ(faults(stream.take_findings()), std::vector{CaptureFault::journal_failed});
  stream.append_event("{\"blow\":3}");
  limit.lift();
  EXPECT_EQ(gaps_until(stream, 99 * kSecond, next), 0U);
  stream.stop();
  EXPECT_TRUE(stream.state().journal_fault.empty());
  EXPECT_EQ(next, 16 * kSecond);
  const JournalReader journal(path);
  EXPECT_EQ(journal.ranges().size(), 1U);
  EXPECT_EQ(journal.end_frame(), 16 * kSecond);
  EXPECT_EQ(journal.torn_bytes(), 0U);
  ASSERT_EQ(journal.events().size(), 1U);
  ASSERT_EQ(journal.findings().size(), 1U);
  EXPECT_EQ(journal.findings()[0].fault, CaptureFault::journal_failed);
}

// The disk is full for longer than the ring buffer holds. The reader still gets every frame, and the journal states
// which frames it lacks.
TEST(FullDisk, LeavesAStatedHoleInTheJournal) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.journal");
  const FileLimit limit;
  CaptureStream stream(synth::open_simulated_device("wood-bat,hits=5,end=22,speed=" PERCUSS_DISK_SPEED),
                       {.journal = path, .store = kStore});
  stream.keep_from(0);
  std::uint64_t next = 0;
  EXPECT_EQ(gaps_until(stream, 3 * kSecond, next), 0U);
  limit.set(stream.state().journal_bytes + 5000);
  EXPECT_EQ(gaps_until(stream, 16 * kSecond, next), 0U);
  limit.lift();
  EXPECT_EQ(gaps_until(stream, 99 * kSecond, next), 0U);
  stream.stop();
  EXPECT_EQ(next, 22 * kSecond);
  EXPECT_EQ(stream.state().dropped_frames, 0U);
  const JournalReader journal(path);
  ASSERT_EQ(journal.ranges().size(), 2U);
  EXPECT_EQ(journal.end_frame(), 22 * kSecond);
  const FrameRange before = journal.ranges()[0], after = journal.ranges()[1];
  const std::uint64_t hole = after.first - (before.first + before.frames);
  ASSERT_EQ(journal.findings().size(), 2U);
  EXPECT_EQ(journal.findings()[1].fault, CaptureFault::not_in_journal);
  EXPECT_EQ(journal.findings()[1].frame, after.first);
  EXPECT_EQ(journal.findings()[1].count, hole);
  EXPECT_GT(hole, kSecond);
}

}  // namespace percuss::acquire::full_disk_test
