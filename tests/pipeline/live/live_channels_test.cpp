#include "pipeline/live/live_channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "support/messages.hpp"

namespace percuss::pipeline::live_channels_test {

using testing::ElementsAre;

LiveChannels channels_of(std::size_t channels, std::vector<Message> notes = {}) {
  return live_channels({.device = "stdin", .fs_Hz = 1000, .channels = channels}, {}, std::move(notes));
}

TEST(LiveChannels, JoinNotesOnUnits) {
  EXPECT_THAT(test::texts(channels_of(2).notes), ElementsAre("the unit of channel 1 is not stated; taken as N",
                                                             "the unit of channel 2 is not stated; taken as m/s^2"));
  EXPECT_THAT(test::texts(channels_of(3).notes),
              ElementsAre("the unit of channel 1 is not stated; taken as N",
                          "the units of channel 2 and channel 3 are not stated; taken as m/s^2"));
  EXPECT_THAT(test::texts(channels_of(4).notes),
              ElementsAre("the unit of channel 1 is not stated; taken as N",
                          "the units of channel 2, channel 3 and channel 4 are not stated; taken as m/s^2"));
  EXPECT_THAT(test::texts(channels_of(200).notes),
              ElementsAre("the unit of channel 1 is not stated; taken as N",
                          "the units of channel 2, channel 3 and 197 more are not stated; taken as m/s^2"));
}

TEST(LiveChannels, BeginWithTheNotesOfTheDevice) {
  EXPECT_THAT(test::texts(channels_of(2, {"a note"}).notes),
              ElementsAre("a note", "the unit of channel 1 is not stated; taken as N",
                          "the unit of channel 2 is not stated; taken as m/s^2"));
}

// The session records only some channels of the device. Each keeps the number of its socket.
TEST(LiveChannels, HaveTheNumbersOfTheDevice) {
  const acquire::StreamFormat format{.device = "eight", .fs_Hz = 1000, .channels = 3, .numbers = {5, 2, 8}};
  const LiveChannels by_place = live_channels(format, {});
  EXPECT_EQ(by_place.force_number, 5U);
  EXPECT_THAT(by_place.accel_numbers, ElementsAre(2, 8));
  EXPECT_EQ(name_of_channel(by_place, 1), "channel 8 (accel 2)");
  acquire::ReadOptions options;
  options.setup = {{.name = "2", .role = "force"}, {.name = "8"}, {.name = "1"}};
  const LiveChannels stated = live_channels(format, options);
  EXPECT_EQ(stated.force, 1U);
  EXPECT_EQ(stated.force_number, 2U);
  EXPECT_THAT(stated.accel, ElementsAre(2));
  EXPECT_THAT(stated.accel_numbers, ElementsAre(8));
}

}  // namespace percuss::pipeline::live_channels_test
