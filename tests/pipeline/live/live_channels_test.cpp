#include "pipeline/live/live_channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "support/input_error.hpp"
#include "support/messages.hpp"

namespace percuss::pipeline::live_channels_test {

using testing::ElementsAre;
using testing::HasSubstr;

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

// A replayed record without a force: its first channel is not the hammer.
TEST(LiveChannels, RefusesChannelsThatAllMeasureResponses) {
  const acquire::StreamFormat format{
      .device = "file:a.csv", .fs_Hz = 1000, .channels = 2, .names = {"CH2", "CH3"}, .units = {"m/s^2", "m/s^2"}};
  EXPECT_THAT(test::input_error_of([&] { live_channels(format, {}); }),
              testing::StartsWith("no channel is a force (file:a.csv)"));
}

// A sound card does not name its channels.
TEST(LiveChannels, TakesEntriesOfASetupWithoutARoleAsResponses) {
  const acquire::StreamFormat format{.device = "card", .fs_Hz = 48000, .channels = 4, .names = {}, .units = {}};
  const auto found = [&](std::vector<acquire::ChannelSetup> setup) {
    acquire::ReadOptions options;
    options.setup = std::move(setup);
    const LiveChannels channels = live_channels(format, options);
    std::vector<std::size_t> out{channels.force};
    out.insert(out.end(), channels.accel.begin(), channels.accel.end());
    return out;
  };
  EXPECT_THAT(found({}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(found({{.name = "2", .role = "force"}}), ElementsAre(1, 0, 2, 3));
  EXPECT_THAT(found({{.name = "1", .role = "force"}, {.name = "2", .angle_rad = 0}, {.name = "4", .angle_rad = 1}}),
              ElementsAre(0, 1, 3));
  EXPECT_THAT(found({{.name = "channel 3"}}), ElementsAre(0, 2));
  EXPECT_THAT(found({{.name = "3", .unit = "N"}, {.name = "1", .unit = "g"}}), ElementsAre(2, 0));
  EXPECT_THAT(test::input_error_of([&] { found({{.name = "1", .role = "ignore"}}); }),
              HasSubstr("leaves open which channels"));
}

}  // namespace percuss::pipeline::live_channels_test
