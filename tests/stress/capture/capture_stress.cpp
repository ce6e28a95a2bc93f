#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/journal_reader.hpp"
#include "support/scratch_folder.hpp"
#include "synth/simulated_device.hpp"

// Long runs of the capture, on request: ctest -C stress-full -L stress. The ordinary tests are shorter, or run faster
// than real time.
namespace percuss::acquire::capture_stress_test {

using namespace std::chrono_literals;
using test::ScratchFolder;

constexpr std::uint64_t kCounterRange = std::uint64_t{1} << 24U;
constexpr std::uint64_t kSecond = 51200;  // in frames

/// Reads up to the frame `last`. Returns the number of frames that are missing or wrong.
std::uint64_t faults_until(CaptureStream& stream, std::uint64_t last, std::uint64_t& next) {
  const std::size_t channels = stream.format().channels;
  std::uint64_t faults = 0;
  while (next < last && stream.end() == StreamEnd::none) {
    const auto block = stream.next(100ms);
    if (!block) continue;
    faults += block->first_frame - next;
    for (std::size_t i = 0; i < block->frames; ++i) {
      const auto number = static_cast<double>((block->first_frame + i) % kCounterRange);
      faults += block->values[(i + 1) * channels - 1] == number ? 0U : 1U;
    }
    next = block->first_frame + block->frames;
  }
  return faults;
}

/// The resident memory of this process in MB.
double resident_MB() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kB = 0;
    if (word == "VmRSS:" && status >> kB) return kB / 1000;
  }
  return 0;
}

// Two stalls of the reader: one that the ring buffer covers, and a longer one.
TEST(CaptureStress, LosesNothingInStallsOf10And20Seconds) {
  const ScratchFolder folder;
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,accels=6,fs=51200,hits=10,every=3,end=45"),
                       {.journal = folder.file("t.journal")});
  stream.keep_from(0);
  std::uint64_t next = 0;
  EXPECT_EQ(faults_until(stream, 3 * kSecond, next), 0U);
  std::this_thread::sleep_for(10s);
  EXPECT_EQ(faults_until(stream, 15 * kSecond, next), 0U);
  std::this_thread::sleep_for(20s);
  EXPECT_GT(stream.state().unread_frames, 19 * kSecond);
  EXPECT_EQ(faults_until(stream, 99 * kSecond, next), 0U);
  EXPECT_EQ(next, 45 * kSecond);
  EXPECT_EQ(stream.state().dropped_frames, 0U);
  stream.stop();
  const JournalReader journal(folder.file("t.journal"));
  EXPECT_EQ(journal.ranges().size(), 1U);
  EXPECT_EQ(journal.end_frame(), 45 * kSecond);
}

TEST(CaptureStress, RunsForADayInFlatMemory) {
  constexpr std::uint64_t kHour = std::uint64_t{2000} * 3600;
  constexpr double kMaxMemory_MB = 64;  // about twice the largest ring of the store, kMaxRing_bytes
  const ScratchFolder folder;
  const double before_MB = resident_MB();
  CaptureStream stream(synth::open_simulated_device("wood-bat,numbered,fs=2000,fast,hits=1439,every=60,end=86400"),
                       {.journal = folder.file("t.journal")});
  stream.keep_from(0);
  std::uint64_t next = 0, faults = faults_until(stream, kHour, next);
  const double hour_MB = resident_MB() - before_MB;
  double largest_MB = hour_MB;
  for (std::uint64_t hour = 2; hour <= 24; ++hour) {
    faults += faults_until(stream, hour * kHour, next);
    stream.append_event("{\"hour\":" + std::to_string(hour) + "}");
    largest_MB = std::max(largest_MB, resident_MB() - before_MB);
  }
  faults += faults_until(stream, 25 * kHour, next);
  stream.stop();
  RecordProperty("hour_kB", static_cast<int>(1000 * hour_MB));
  RecordProperty("largest_kB", static_cast<int>(1000 * largest_MB));
  EXPECT_EQ(next, 24 * kHour);
  EXPECT_EQ(faults, 0U);
  EXPECT_LE(largest_MB, kMaxMemory_MB);
  constexpr double kGrowth_MB = 4;  // of the allocator
  EXPECT_LE(largest_MB, hour_MB + kGrowth_MB);
  const JournalReader journal(folder.file("t.journal"));
  EXPECT_EQ(journal.end_frame(), 24 * kHour);
  EXPECT_EQ(journal.events().size(), 23U);
  EXPECT_LE(resident_MB() - before_MB, kMaxMemory_MB);
}

}  // namespace percuss::acquire::capture_stress_test
