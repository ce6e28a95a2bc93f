#include "acquire/live/frame_ring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <thread>
#include <vector>

namespace percuss::acquire::frame_ring_test {

using testing::ElementsAre;

FrameLayout layout(std::size_t channels, SampleType type = SampleType::int32, double scale = 1) {
  FrameLayout out{.type = type, .device_channels = channels, .scales = std::vector(channels, scale)};
  for (std::size_t c = 0; c < channels; ++c) out.channels.push_back(c);
  return out;
}

std::vector<double> values(const FrameRing& ring, std::uint64_t index, std::size_t count) {
  std::vector<double> out(count);
  ring.read(index, out);
  return out;
}

TEST(FrameRing, ReturnsFramesInOrderAcrossItsEnd) {
  FrameRing ring(layout(2), 3);
  const std::vector<std::int32_t> first{1, -1, 2, -2}, second{3, -3, 4, -4};
  ring.write(first.data(), 2);
  EXPECT_THAT(values(ring, 0, 4), ElementsAre(1, -1, 2, -2));
  ring.release(1);
  ring.write(second.data(), 2);
  EXPECT_EQ(ring.range_from(1, 10).frames, 3U);
  EXPECT_THAT(values(ring, 1, 6), ElementsAre(2, -2, 3, -3, 4, -4));
  EXPECT_EQ(ring.dropped(), 0U);
}

TEST(FrameRing, ScalesNumbersOfEachType) {
  FrameRing ints(layout(1, SampleType::int32, 0x1p-31), 4);
  const std::int32_t lowest = INT32_MIN;
  ints.write(&lowest, 1);
  EXPECT_EQ(values(ints, 0, 1)[0], -1);
  FrameRing floats(layout(1, SampleType::float32, 2), 4);
  const float quarter = 0.25F;
  floats.write(&quarter, 1);
  EXPECT_EQ(values(floats, 0, 1)[0], 0.5);
  FrameRing doubles(layout(1, SampleType::float64), 4);
  const double third = 1.0 / 3;
  doubles.write(&third, 1);
  EXPECT_EQ(values(doubles, 0, 1)[0], 1.0 / 3);
}

TEST(FrameRing, KeepsAndScalesTheChosenChannels) {
  FrameRing ring({.type = SampleType::int32, .device_channels = 3, .channels = {2, 0}, .scales = {1, 10}}, 4);
  const std::vector<std::int32_t> frames{1, 2, 3, 4, 5, 6};
  ring.write(frames.data(), 2);
  EXPECT_THAT(values(ring, 0, 4), ElementsAre(3, 10, 6, 40));
}

TEST(FrameRing, PutsAllChannelsIntoTheChosenOrder) {
  FrameRing ring({.type = SampleType::int32, .device_channels = 3, .channels = {1, 0, 2}, .scales = {1, 10, 100}}, 4);
  const std::vector<std::int32_t> frames{1, 2, 3, 4, 5, 6};
  ring.write(frames.data(), 2);
  EXPECT_THAT(values(ring, 0, 6), ElementsAre(2, 10, 300, 5, 40, 600));
}

// Frames that find no room are counted, and the numbers of later frames include them.
TEST(FrameRing, CountsWhatItDrops) {
  FrameRing ring(layout(1), 3);
  const std::vector<std::int32_t> frames{0, 1, 2, 3, 4};
  ring.write(frames.data(), 5);
  EXPECT_EQ(ring.dropped(), 2U);
  EXPECT_EQ(ring.room(), 0U);
  ring.write(frames.data(), 1);
  ring.release(3);
  ring.write(frames.data(), 2);
  const RingRange before = ring.range_from(0, 10), after = ring.range_from(3, 10);
  EXPECT_EQ(before.frames, 3U);
  EXPECT_FALSE(before.overrun);
  EXPECT_EQ(after.first_frame, 6U);
  EXPECT_EQ(after.frames, 2U);
  EXPECT_TRUE(after.overrun);
  EXPECT_FALSE(ring.range_from(4, 10).overrun);
}

TEST(FrameRing, SeparatesFramesAtALossThatTheDeviceStates) {
  FrameRing ring(layout(1), 100, 1000);
  const std::vector<std::int32_t> frames(10);
  ring.write(frames.data(), 10);
  ring.skip(7, false);
  ring.write(frames.data(), 10);
  ring.skip(0, true);
  ring.write(frames.data(), 10);
  EXPECT_EQ(ring.range_from(0, 99).frames, 10U);
  const RingRange second = ring.range_from(10, 99), third = ring.range_from(20, 99);
  EXPECT_EQ(second.first_frame, 1017U);
  EXPECT_FALSE(second.overrun);
  EXPECT_EQ(third.first_frame, 1027U);
  EXPECT_TRUE(third.overrun);
  EXPECT_EQ(ring.index_of(1009), 9U);
  EXPECT_EQ(ring.index_of(1012), 10U);  // lost: the next one
  EXPECT_EQ(ring.index_of(1017), 10U);
  EXPECT_EQ(ring.index_of(0), 0U);
}

// More losses than the ring stores for its consumer: the frames after them are dropped too, but never misnumbered.
TEST(FrameRing, NumbersFramesCorrectlyAfterManyLosses) {
  FrameRing ring(layout(1), 10000);
  std::int32_t number = 0;
  for (int i = 0; i < 1000; ++i) {
    ring.write(&number, 1);
    number += 2;
    ring.skip(1, false);
  }
  std::uint64_t index = 0;
  std::size_t seen = 0;
  while (index < ring.written()) {
    const RingRange range = ring.range_from(index, 10000);
    if (range.frames == 0) break;
    EXPECT_EQ(values(ring, index, 1)[0], static_cast<double>(range.first_frame));
    index += range.frames;
    seen += range.frames;
  }
  EXPECT_EQ(seen + ring.dropped(), 1000U);
  EXPECT_GT(seen, 200U);  // the ring stores 256 losses
}

TEST(FrameRing, KeepsTheFirstReasonToEnd) {
  FrameRing ring(layout(1), 1);
  EXPECT_EQ(ring.ended(), StreamEnd::none);
  ring.end(StreamEnd::unplugged);
  ring.end(StreamEnd::finished);
  EXPECT_EQ(ring.ended(), StreamEnd::unplugged);
}

// Under the thread sanitizer this test also finds races.
TEST(FrameRing, PassesNumberedFramesBetweenThreads) {
  constexpr std::int32_t kFrames = 200000;
  FrameRing ring(layout(2), 1000);
  std::thread producer([&] {
    for (std::int32_t frame = 0; frame < kFrames;) {
      std::vector<std::int32_t> piece;
      for (int i = 0; i < 37 && frame < kFrames; ++i, ++frame) piece.insert(piece.end(), {frame, -frame});
      while (ring.room() < piece.size() / 2) std::this_thread::yield();
      ring.write(piece.data(), piece.size() / 2);
    }
    ring.end(StreamEnd::finished);
  });
  std::uint64_t index = 0, wrong = 0;
  while (ring.ended() == StreamEnd::none || index < ring.written()) {
    const RingRange range = ring.range_from(index, 64);
    const std::vector<double> got = values(ring, index, range.frames * 2);
    for (std::size_t i = 0; i < range.frames; ++i) {
      const auto expected = static_cast<double>(range.first_frame + i);
      if (got[2 * i] != expected || got[2 * i + 1] != -expected) ++wrong;
    }
    index += range.frames;
    ring.release(index);
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(index, static_cast<std::uint64_t>(kFrames));
}

}  // namespace percuss::acquire::frame_ring_test
