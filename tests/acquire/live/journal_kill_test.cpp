#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/journal_reader.hpp"
#include "support/scratch_folder.hpp"
#include "synth/simulated_device.hpp"

// Kills a capture at random moments. Each run resumes the journal of the run before.
namespace percuss::acquire::journal_kill_test {

using namespace std::chrono_literals;
using test::ScratchFolder;

constexpr std::uint64_t kBlock_frames = 2560;  // 0.1 s

/// What the killed process had done, in memory that survives it.
struct Progress {
  std::atomic<std::uint64_t> written_bytes{0};  // of the journal, in whole blocks
  std::atomic<std::uint64_t> read_frame{0};     // the reader saw the frames before this one
  std::atomic<std::uint64_t> events{0};         // calls of append_event() that have returned
};

[[noreturn]] void capture(const std::string& path, bool resume, Progress& progress) {
  CaptureStream stream(synth::open_simulated_device("wood-bat,numbered,first=0.1,end=100000"),
                       {.journal = path, .resume = resume});
  stream.keep_from(0);
  for (std::uint64_t number = 0;;) {
    const auto block = stream.next(100ms);
    progress.written_bytes = stream.state().journal_bytes;
    if (!block) continue;
    progress.read_frame = block->first_frame + block->frames;
    if (++number % 4 != 0) continue;
    stream.append_event("{\"blow\":" + std::to_string(number) + "}");
    ++progress.events;
  }
}

/// Starts a capture, waits until its first block is read, then for the time `after`, and kills it.
void run_and_kill(const std::string& path, bool resume, std::chrono::microseconds after, Progress& progress) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::alarm(60);
    capture(path, resume, progress);
  }
  while (progress.read_frame == 0 && ::waitpid(child, nullptr, WNOHANG) == 0) std::this_thread::sleep_for(200us);
  std::this_thread::sleep_for(after);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

// The last channel of a numbered device counts the frames. The count starts again at 0 in every session.
std::uint64_t wrong_numbers_in(const JournalReader& journal, const FrameRange& range) {
  const std::size_t channels = journal.format().channels;
  const auto values = journal.read(range.first, static_cast<std::size_t>(range.frames));
  const double start = values[channels - 1];
  std::uint64_t wrong = 0;
  for (std::size_t i = 0; i < range.frames; ++i)
    wrong += values[(i + 1) * channels - 1] == start + static_cast<double>(i) ? 0U : 1U;
  return wrong;
}

TEST(JournalKill, LosesLessThanTwoBlocks) {
  // A stress run sets the number: 1000 kills take some minutes.
  const char* const asked = std::getenv("PERCUSS_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 12;
  const ScratchFolder folder;
  const std::string path = folder.file("t.journal");
  void* const memory = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  std::uint64_t random = 1, events = 0, ranges = 0, begun = 0, torn = 0, largest_loss = 0;
  for (int i = 0; i < kills; ++i) {
    auto* const progress = new (memory) Progress;
    // A journal of many sessions takes long to read again.
    constexpr int kSessions = 40;
    const bool anew = i % kSessions == 0;
    if (anew) {
      std::remove(path.c_str());
      events = ranges = 0;
    }
    random = random * 6364136223846793005U + 1442695040888963407U;
    run_and_kill(path, !anew, std::chrono::microseconds((random >> 33U) % 400000), *progress);
    const JournalReader journal(path);
    const std::uint64_t bytes = journal.whole_bytes();
    torn += journal.torn_bytes() > 0 ? 1U : 0U;
    EXPECT_GE(bytes, progress->written_bytes);
    EXPECT_GE(journal.events().size(), events + progress->events) << "an event that was acknowledged is lost";
    EXPECT_LE(journal.events().size(), events + progress->events + 1);
    events = journal.events().size();
    if (journal.ranges().size() == ranges) continue;  // killed before its first block was written
    EXPECT_EQ(journal.ranges().size(), ranges + 1);
    ranges = journal.ranges().size();
    ++begun;
    EXPECT_EQ(wrong_numbers_in(journal, journal.ranges().back()), 0U);
    const std::uint64_t seen = progress->read_frame;
    largest_loss = std::max(largest_loss, seen - std::min(seen, journal.end_frame()));
  }
  EXPECT_GT(begun, static_cast<std::uint64_t>(kills) / 2);
  RecordProperty("largest_loss_frames", static_cast<int>(largest_loss));
  RecordProperty("torn_journals", static_cast<int>(torn));
  // A kill loses the block being collected. On a busy machine the writer may wait, and up to one more block is lost.
  EXPECT_LT(largest_loss, 2 * kBlock_frames);
  ::munmap(memory, sizeof(Progress));
}

}  // namespace percuss::acquire::journal_kill_test
