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

}  // namespace percuss::pipeline::live_channels_test
