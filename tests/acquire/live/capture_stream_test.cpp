#include "acquire/live/capture_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "acquire/live/journal_reader.hpp"
#include "core/error.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"
#include "synth/simulated_device.hpp"

namespace percuss::acquire::capture_stream_test {

using namespace std::chrono_literals;
using test::input_error_of;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Speeds of the simulated device, in multiples of real time. Sanitizers make it slower.
#ifdef PERCUSS_SANITIZED
constexpr int kSpeed = 1, kStallSpeed = 5;
#else
constexpr int kSpeed = 4, kStallSpeed = 10;
#endif

/// A device with this speed.
std::unique_ptr<Device> at_speed(int speed, const std::string& description) {
  return synth::open_simulated_device(description + ",speed=" + std::to_string(speed));
}

constexpr std::uint64_t kCounterRange = std::uint64_t{1} << 24U;

/// The frames that a reader received from a stream whose last channel counts the frames.
struct Seen {
  std::uint64_t frames = 0, wrong = 0, jumps = 0, lost = 0, after_loss = 0, next = 0;
  bool begun = false;

  void add(const SampleBlock& block, std::size_t channels) {
    if (begun && block.first_frame != next) {
      ++jumps;
      lost += block.first_frame - next;
      after_loss = block.first_frame;
    }
    begun = true;
    for (std::size_t i = 0; i < block.frames; ++i) {
      const double number = block.values[(i + 1) * channels - 1];
      if (number != static_cast<double>((block.first_frame + i) % kCounterRange)) ++wrong;
    }
    frames += block.frames;
    next = block.first_frame + block.frames;
  }
};

void read_all(CaptureStream& stream, Seen& seen) {
  while (stream.end() == StreamEnd::none) {
    if (const auto block = stream.next(100ms)) seen.add(*block, stream.format().channels);
  }
}

std::map<CaptureFault, std::uint64_t> counts(const std::vector<CaptureFinding>& findings) {
  std::map<CaptureFault, std::uint64_t> out;
  for (const CaptureFinding& finding : findings) out[finding.fault] += finding.count;
  return out;
}

std::uint64_t wrong_numbers(const JournalReader& journal) {
  Seen seen;
  for (const FrameRange& range : journal.ranges()) {
    for (std::uint64_t done = 0; done < range.frames;) {
      const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(4096, range.frames - done));
      seen.add({.first_frame = range.first + done, .frames = part, .values = journal.read(range.first + done, part)},
               journal.format().channels);
      done += part;
    }
  }
  return seen.wrong;
}

TEST(CaptureStream, DeliversEachFrameOnce) {
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=3"), {});
  EXPECT_EQ(stream.format().channels, 4U);
  EXPECT_THAT(stream.format().units, ElementsAre("N", "m/s^2", "m/s^2", ""));
  Seen seen;
  read_all(stream, seen);
  EXPECT_EQ(stream.end(), StreamEnd::finished);
  EXPECT_EQ(seen.frames, 10U * 25600U);  // blows at 1, 3 and 5 s, and 5 s after them
  EXPECT_EQ(seen.wrong + seen.jumps, 0U);
  EXPECT_THAT(stream.take_findings(), IsEmpty());
}

// The device writes pieces of 2048 frames; the ring holds 8192, the fewest for frames of 16 bytes.
TEST(CaptureStream, DeliversThroughTheSmallestRing) {
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=1"),
                       {.store = {.history_s = 2, .ring_s = 0.02}});
  Seen seen;
  read_all(stream, seen);
  EXPECT_EQ(seen.frames, 6U * 25600U);
  EXPECT_EQ(seen.wrong + seen.jumps, 0U);
}

/// A device that does not start.
class UnstartableDevice final : public Device {
 public:
  const DeviceFormat& format() const override { return format_; }
  void start(FrameSink&) override { throw InputError("the device does not start", "bench", "switch it on"); }
  void stop() override {}

 private:
  const DeviceFormat format_{.stream = {.device = "bench", .fs_Hz = 1000, .channels = 2}};
};

TEST(CaptureStream, LeavesNoJournalOfADeviceThatDoesNotStart) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  for (int trial = 0; trial < 2; ++trial) {
    EXPECT_THAT(input_error_of([&] { CaptureStream(std::make_unique<UnstartableDevice>(), {.journal = path}); }),
                HasSubstr("does not start"));
    EXPECT_FALSE(std::filesystem::exists(path));
  }
}

TEST(CaptureStream, DeliversChosenChannels) {
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=1,end=1"), {.channels = {0, 3}});
  EXPECT_THAT(stream.format().names, ElementsAre("force", "count"));
  Seen seen;
  read_all(stream, seen);
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_THAT(input_error_of([] { CaptureStream(synth::open_simulated_device("aluminium-bat"), {.channels = {3}}); }),
              HasSubstr("there is no channel 4"));
}

TEST(CaptureStream, JournalsFromTheFrameThatTheGuidanceNames) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=1,first=1"),
                       {.journal = path, .store = {.history_s = 2}});
  stream.append_event("{\"point\":0}");
  Seen seen;
  while (seen.frames < 30000) {
    if (const auto block = stream.next(100ms)) seen.add(*block, 4);
  }
  stream.keep_from(20000);
  stream.append_event("{\"blow\":1}");
  read_all(stream, seen);
  stream.stop();
  const JournalReader journal(path);
  constexpr std::uint64_t kSecond = 25600;
  EXPECT_THAT(journal.ranges(), ElementsAre(FrameRange{20000, 6 * kSecond - 20000}));
  ASSERT_EQ(journal.events().size(), 2U);
  EXPECT_EQ(journal.events()[0].frame, 0U);
  EXPECT_EQ(wrong_numbers(journal), 0U);
}

// A device without a clock runs ahead of the reader. At a low rate, the device is many seconds further when the reader
// finds the first blow.
TEST(CaptureStream, JournalsFromAnEarlyFrameAtALowRate) {
  for (const auto stall : {0ms, 3ms, 30ms}) {
    const ScratchFolder folder;
    const std::string path = folder.file("t.h5.journal"), spec = folder.file("slow.json");
    std::ofstream(spec)
        << R"({"fs_hz": 50, "duration_s": 20, "band_hz": [1, 20], "modes": [{"frequency_hz": 2, "damping_ratio": 0.05,
        "residue_per_kg": [0.02]}], "sensors": [{"position_m": 0}], "impact": {"position_m": 0},
        "pulse": {"width_s": 0.04, "peak_n": 300}})";
    CaptureStream stream(synth::open_simulated_device(spec + ",numbered,fast,hits=1,first=1,end=400"),
                         {.journal = path});
    std::this_thread::sleep_for(stall);
    Seen seen;
    while (seen.frames < 700) {
      if (const auto block = stream.next(100ms)) seen.add(*block, 3);
    }
    std::this_thread::sleep_for(stall);
    stream.keep_from(13);
    read_all(stream, seen);
    stream.stop();
    const JournalReader journal(path);
    const std::uint64_t first = journal.ranges().front().first;
    EXPECT_LE(first, 13U);  // a stall begins the journal earlier
    EXPECT_THAT(journal.ranges(), ElementsAre(FrameRange{first, 20000 - first}));
    EXPECT_EQ(seen.frames, 20000U);
    EXPECT_EQ(wrong_numbers(journal) + seen.wrong + seen.jumps, 0U);
    EXPECT_THAT(stream.take_findings(), IsEmpty());
  }
}

TEST(CaptureStream, JournalsNothingUntilItIsAsked) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=1"), {.journal = path});
  Seen seen;
  read_all(stream, seen);
  stream.stop();
  EXPECT_EQ(JournalReader(path).frames(), 0U);
  EXPECT_EQ(seen.frames, 6U * 25600U);
}

// A short session in a pipe ends before its first block is read.
TEST(CaptureStream, JournalsWhatIsAskedAfterTheDeviceHasEnded) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=1,end=1.5"), {.journal = path});
  Seen seen;
  read_all(stream, seen);
  stream.keep_from(1000);
  stream.stop();
  const JournalReader journal(path);
  EXPECT_THAT(journal.ranges(), ElementsAre(FrameRange{1000, 38400 - 1000}));
  EXPECT_EQ(wrong_numbers(journal), 0U);
}

// The reader stalls while the device delivers ten seconds of 8 channels at 51.2 kHz, at kSpeed times real time. The
// ring holds 4 s of them; the rest is read back from the journal. The stress tests do the same in real time.
TEST(CaptureStream, LosesNothingWhileTheReaderStalls) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  CaptureStream stream(at_speed(kSpeed, "aluminium-bat,numbered,accels=6,fs=51200,hits=5,end=13"),
                       {.journal = path, .store = {.ring_s = 4}});
  stream.keep_from(0);
  Seen seen;
  while (seen.frames < 51200) {
    if (const auto block = stream.next(100ms)) seen.add(*block, 8);
  }
  std::this_thread::sleep_for(10000ms / kSpeed);
  EXPECT_GT(stream.state().unread_frames, 9U * 51200U);
  read_all(stream, seen);
  EXPECT_EQ(seen.frames, 13U * 51200U);
  EXPECT_EQ(seen.wrong + seen.jumps, 0U);
  EXPECT_EQ(stream.state().dropped_frames, 0U);
  EXPECT_EQ(wrong_numbers(JournalReader(path)), 0U);
}

// A block of the journal that is damaged before the stalled reader reads it back is lost. Its finding states the frame
// after the loss, as for other dropped frames.
TEST(CaptureStream, NamesTheFramesThatTheJournalDoesNotGiveBack) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.h5.journal");
  CaptureStream stream(at_speed(kStallSpeed, "aluminium-bat,numbered,hits=1,first=9"),
                       {.journal = path, .store = {.ring_s = 4}});
  stream.keep_from(0);
  std::this_thread::sleep_for(10000ms / kStallSpeed);
  {
    std::fstream journal(path, std::ios::in | std::ios::out | std::ios::binary);
    journal.seekp(static_cast<std::streamoff>(std::filesystem::file_size(path) / 4));
    journal.write("damaged", 7);
  }
  Seen seen;
  read_all(stream, seen);
  std::vector<CaptureFinding> dropped = stream.take_findings();
  std::erase_if(dropped, [](const CaptureFinding& finding) { return finding.fault != CaptureFault::dropped; });
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(seen.jumps, 1U);
  EXPECT_GT(dropped[0].count, 0U);
  EXPECT_EQ(dropped[0].count, seen.lost);
  EXPECT_EQ(dropped[0].frame, seen.after_loss);
}

// When the reader stalls, the stream starts to write samples to the journal, so that none are lost.
TEST(CaptureStream, JournalsAStallBeforeTheFirstBlow) {
  const ScratchFolder folder;
  CaptureStream stream(at_speed(kStallSpeed, "aluminium-bat,numbered,hits=1,first=9"),
                       {.journal = folder.file("t.journal"), .store = {.ring_s = 4}});
  std::this_thread::sleep_for(14000ms / kStallSpeed);
  Seen seen;
  read_all(stream, seen);
  EXPECT_EQ(seen.frames, 14U * 25600U);
  EXPECT_EQ(seen.wrong + seen.jumps, 0U);
}

TEST(CaptureStream, CountsWhatAStallLosesWithoutAJournal) {
  CaptureStream stream(at_speed(kStallSpeed, "aluminium-bat,numbered,hits=1,first=9"), {.store = {.ring_s = 4}});
  std::this_thread::sleep_for(14000ms / kStallSpeed);
  Seen seen;
  read_all(stream, seen);
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_LT(seen.frames, 14U * 25600U);
  constexpr std::uint64_t kSent = std::uint64_t{14} * 25600U;
  EXPECT_EQ(stream.state().dropped_frames, kSent - seen.frames);
  EXPECT_EQ(counts(stream.take_findings())[CaptureFault::dropped], stream.state().dropped_frames);
}

TEST(CaptureStream, StatesGapsAndOverruns) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.journal");
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,numbered,fast,hits=2,gap=2:2,overrun=4.5:0.01"),
                       {.journal = path});
  stream.keep_from(0);
  Seen seen;
  read_all(stream, seen);
  stream.stop();
  EXPECT_EQ(seen.jumps, 2U);
  EXPECT_EQ(seen.lost, 2U * 25600U + 256U);
  EXPECT_EQ(seen.wrong, 0U);
  const auto findings = stream.take_findings();
  ASSERT_EQ(findings.size(), 2U);
  constexpr std::uint64_t kSecond = 25600;
  EXPECT_EQ(findings[0], (CaptureFinding{.fault = CaptureFault::gap, .frame = 4 * kSecond, .count = 2 * kSecond}));
  EXPECT_EQ(findings[1].fault, CaptureFault::overrun);
  EXPECT_EQ(findings[1].count, 256U);
  const JournalReader journal(path);
  EXPECT_EQ(journal.findings(), findings);
  EXPECT_EQ(journal.ranges().size(), 3U);
  EXPECT_EQ(wrong_numbers(journal), 0U);
}

TEST(CaptureStream, CountsFaultySamples) {
  CaptureStream stream(synth::open_simulated_device("aluminium-bat,fast,hits=1,nan=2:0.01,overload=3:0.02,end=4"), {});
  std::uint64_t no_numbers = 0;
  while (stream.end() == StreamEnd::none) {
    const auto block = stream.next(100ms);
    for (std::size_t i = 0; block && i < block->values.size(); ++i)
      no_numbers += std::isnan(block->values[i]) ? 1U : 0U;
  }
  const auto found = counts(stream.take_findings());
  EXPECT_EQ(no_numbers, 2U * 256U);
  EXPECT_EQ(found.at(CaptureFault::not_a_number), 2U * 256U);
  EXPECT_EQ(found.at(CaptureFault::overload), 2U * 512U);
}

TEST(CaptureStream, TellsWhyItEnds) {
  const auto end_of = [](const std::string& device) {
    CaptureStream stream(synth::open_simulated_device(device), {});
    Seen seen;
    read_all(stream, seen);
    const auto findings = stream.take_findings();
    EXPECT_EQ(findings.empty(), stream.end() == StreamEnd::finished);
    return stream.end();
  };
  EXPECT_EQ(end_of("wood-bat,fast,numbered,hits=1"), StreamEnd::finished);
  EXPECT_EQ(end_of("wood-bat,fast,numbered,hits=1,unplug=1.5"), StreamEnd::unplugged);
  EXPECT_EQ(end_of("wood-bat,fast,numbered,hits=1,rate=1.5"), StreamEnd::rate_changed);
}

TEST(CaptureStream, StopsAtOnceAndKeepsWhatItHas) {
  CaptureStream stream(synth::open_simulated_device("wood-bat,numbered,speed=10"), {});
  std::this_thread::sleep_for(100ms);
  const auto begun = std::chrono::steady_clock::now();
  stream.stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 500ms);
  Seen seen;
  read_all(stream, seen);
  EXPECT_GT(seen.frames, 0U);
  EXPECT_EQ(stream.end(), StreamEnd::finished);
}

TEST(CaptureStream, ResumesItsJournal) {
  const ScratchFolder folder;
  const std::string path = folder.file("t.journal");
  const auto run = [&](bool resume) {
    CaptureStream stream(synth::open_simulated_device("wood-bat,fast,numbered,hits=1"),
                         {.journal = path, .resume = resume});
    stream.keep_from(0);
    Seen seen;
    read_all(stream, seen);
    return seen;
  };
  const Seen first = run(false), second = run(true);
  EXPECT_EQ(second.next, first.next + 25600 + first.frames);  // a second between the sessions
  const JournalReader journal(path);
  EXPECT_EQ(journal.ranges().size(), 2U);
  ASSERT_EQ(journal.findings().size(), 1U);
  EXPECT_EQ(journal.findings()[0].fault, CaptureFault::resumed);
}

}  // namespace percuss::acquire::capture_stream_test
