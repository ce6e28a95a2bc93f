#include "batch/serialized_frf.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace percuss::batch::serialized_frf_test {

acquire::FrfRecord small_record() {
  acquire::FrfRecord record;
  record.lines = {.fs_Hz = 1000, .samples = 100, .first = 7, .count = 2};
  record.accel = {{.name = "a", .angle_rad = 0.5}, {.name = "b", .position_m = 0.05}};
  record.estimator = "Hv";
  record.decay_per_s = 3;
  for (std::size_t c = 0; c < 2; ++c) {
    record.frfs.push_back({.point = 4, .channel = c, .frf = {}});
    record.frfs.back().frf.value = {Complex(1, 2), Complex(3, -4)};
    record.frfs.back().frf.averages = 5;
  }
  record.frfs[0].frf.std = {0.1, 0.2};
  record.frfs[0].frf.coherence = {1, 0.9};
  return record;
}

TEST(SerializedFrf, IsRestoredExactly) {
  const acquire::FrfRecord record = small_record(), back = deserialize_frfs(serialize_frfs(record), "here");
  EXPECT_EQ(back.lines.fs_Hz, 1000);
  EXPECT_EQ(back.lines.samples, 100U);
  EXPECT_EQ(back.lines.first, 7U);
  EXPECT_EQ(back.estimator, "Hv");
  EXPECT_EQ(back.decay_per_s, 3);
  ASSERT_EQ(back.accel.size(), 2U);
  EXPECT_EQ(back.accel[0].angle_rad, 0.5);
  EXPECT_EQ(back.accel[1].position_m, 0.05);
  ASSERT_EQ(back.frfs.size(), 2U);
  EXPECT_EQ(back.frfs[1].channel, 1U);
  EXPECT_EQ(back.frfs[1].point, 4);
  EXPECT_EQ(back.frfs[1].frf.value, record.frfs[1].frf.value);
  EXPECT_EQ(back.frfs[0].frf.std, record.frfs[0].frf.std);
  EXPECT_EQ(back.frfs[0].frf.coherence, record.frfs[0].frf.coherence);
  EXPECT_EQ(back.frfs[0].frf.averages, 5U);
  EXPECT_EQ(serialize_frfs(back), serialize_frfs(record));
}

TEST(SerializedFrf, IsRejectedWhenCutOffOrChanged) {
  const std::string text = serialize_frfs(small_record());
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_THROW(deserialize_frfs(text.substr(0, length), "here"), InputError) << length;
  acquire::FrfRecord record = small_record();
  record.lines.count = 3;
  EXPECT_THROW(deserialize_frfs(serialize_frfs(record), "here"), InputError);
  record = small_record();
  record.frfs[0].channel = 2;
  EXPECT_THROW(deserialize_frfs(serialize_frfs(record), "here"), InputError);
}

}  // namespace percuss::batch::serialized_frf_test
