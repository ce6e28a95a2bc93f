#include "pipeline/live/sample_history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace percuss::pipeline::sample_history_test {

using acquire::SampleBlock;
using testing::ElementsAre;

// Two channels: the frame's number, and its negative.
SampleBlock block(std::uint64_t first, std::size_t frames) {
  SampleBlock out{.first_frame = first, .frames = frames};
  for (std::uint64_t frame = first; frame < first + frames; ++frame) {
    out.values.push_back(static_cast<double>(frame));
    out.values.push_back(-static_cast<double>(frame));
  }
  return out;
}

std::vector<double> read(const SampleHistory& history, std::size_t channel, std::uint64_t first, std::size_t count) {
  std::vector<double> out(count);
  history.read(channel, first, out);
  return out;
}

TEST(SampleHistory, ReadsAcrossBlocks) {
  SampleHistory history(2);
  history.add(block(10, 3));
  history.add(block(13, 4));
  EXPECT_EQ(history.first_frame(), 10U);
  EXPECT_EQ(history.end_frame(), 17U);
  EXPECT_THAT(read(history, 0, 11, 5), ElementsAre(11, 12, 13, 14, 15));
  EXPECT_THAT(read(history, 1, 12, 2), ElementsAre(-12, -13));
  EXPECT_TRUE(history.losses(10, 17).empty());
}

TEST(SampleHistory, HoldsThePlaceOfLostFrames) {
  SampleHistory history(2);
  history.add(block(0, 3));
  history.add(block(6, 2));
  EXPECT_THAT(read(history, 0, 1, 7), ElementsAre(1, 2, 2, 2, 2, 6, 7));
  EXPECT_THAT(read(history, 0, 4, 3), ElementsAre(2, 2, 6));
  const auto losses = history.losses(0, 8);
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_EQ(losses[0].frame, 3U);
  EXPECT_EQ(losses[0].frames, 3U);
  EXPECT_TRUE(history.losses(0, 3).empty());
  EXPECT_TRUE(history.losses(6, 8).empty());
}

TEST(SampleHistory, KnowsOverrunsAndValuesThatAreNoNumbers) {
  SampleHistory history(2);
  history.add(block(0, 3));
  SampleBlock overrun = block(3, 3);
  overrun.overrun = true;
  overrun.values[2] = std::numeric_limits<double>::quiet_NaN();  // frame 4
  overrun.values[4] = std::numeric_limits<double>::infinity();   // frame 5
  history.add(overrun);
  EXPECT_THAT(read(history, 0, 2, 4), ElementsAre(2, 3, 3, 3));
  const auto losses = history.losses(0, 6);
  ASSERT_EQ(losses.size(), 2U);
  EXPECT_TRUE(losses[0].overrun);
  EXPECT_EQ(losses[1].frame, 4U);
  EXPECT_EQ(losses[1].frames, 2U);
}

// Consecutive samples of a channel without a number are one loss, also across blocks and beside losses of other
// channels.
TEST(SampleHistory, JoinsSamplesWithoutNumbersAcrossBlocks) {
  SampleHistory history(2);
  for (std::uint64_t first = 0; first < 40; first += 10) {
    SampleBlock dead = block(first, 10);
    for (std::size_t i = 1; i < dead.values.size(); i += 2) dead.values[i] = std::numeric_limits<double>::quiet_NaN();
    if (first == 20) dead.values[0] = std::numeric_limits<double>::infinity();
    history.add(dead);
  }
  const auto losses = history.losses(5, 40);
  ASSERT_EQ(losses.size(), 2U);
  EXPECT_EQ(losses[0].frame, 0U);
  EXPECT_EQ(losses[0].frames, 40U);
  EXPECT_EQ(losses[0].channel, 1U);
  EXPECT_EQ(losses[1].frame, 20U);
  EXPECT_EQ(losses[1].channel, 0U);
}

// Frames in a gap have the same values whether or not older frames were discarded.
TEST(SampleHistory, KeepsTheValueBeforeAGap) {
  SampleHistory history(2);
  history.add(block(0, 10));
  history.add(block(50, 10));
  history.discard_before(30);
  EXPECT_THAT(read(history, 0, 48, 4), ElementsAre(9, 9, 50, 51));
}

TEST(SampleHistory, DiscardsOldFramesAndIgnoresRepeatedOnes) {
  SampleHistory history(2);
  for (std::uint64_t first = 0; first < 100; first += 10) history.add(block(first, 10));
  history.add(block(95, 10));  // repeats five frames
  EXPECT_EQ(history.end_frame(), 105U);
  history.discard_before(57);
  EXPECT_EQ(history.first_frame(), 50U);
  EXPECT_THAT(read(history, 0, 98, 4), ElementsAre(98, 99, 100, 101));
  EXPECT_TRUE(history.losses(0, 105).empty());
  EXPECT_THROW(history.add({.first_frame = 105, .frames = 2, .values = {1}}), std::invalid_argument);
}

}  // namespace percuss::pipeline::sample_history_test
