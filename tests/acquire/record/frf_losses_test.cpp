#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/write_record.hpp"

namespace percuss::acquire::frf_losses_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

FrfRecord measured(std::size_t averages) {
  FrfRecord out{.lines = {.fs_Hz = 8, .samples = 8, .first = 1, .count = 2}, .accel = {{.name = "accel 1"}}};
  out.frfs.push_back({.frf = {.value = {1, 2}, .std = {0.1, 0.1}, .coherence = {0.9, 0.9}, .averages = averages}});
  return out;
}

TEST(FrfLosses, NameStandardDeviationsThatAUniversalFileCannotGiveBack) {
  EXPECT_THAT(losses_of("a.uff", measured(0)), ElementsAre("the standard deviations"));
  EXPECT_THAT(losses_of("a.uff", measured(5)), IsEmpty());  // computed from the coherence and the averages
  EXPECT_THAT(losses_of("a.h5", measured(0)), IsEmpty());
}

TEST(FrfLosses, NamePositionsThatTextDrops) {
  FrfRecord record = measured(5);
  record.accel.front().position_m = 0.1;
  EXPECT_THAT(losses_of("a.csv", record), ElementsAre("the sensors' positions"));
}

TEST(FrfLosses, NameTheChannelsOwnNames) {
  FrfRecord record = measured(0);
  record.accel.front().name = "tip";
  for (const char* path : {"a.h5", "a.csv", "a.uff", "a.mat"})
    EXPECT_THAT(losses_of(path, record), Contains("the channels' names")) << path;
}

TEST(FrfLosses, NameDirections) {
  FrfRecord record = measured(5);
  record.motions.push_back({.point = 0, .place = 0, .along = Direction{0, 0, 1}});
  record.sensor_roves = true;
  for (const char* path : {"a.h5", "a.csv", "a.uff", "a.mat"}) {
    EXPECT_THAT(losses_of(path, record),
                testing::IsSupersetOf({"the directions of motion", "that the sensors moved and the hammer did not"}))
        << path;
  }
}

}  // namespace percuss::acquire::frf_losses_test
