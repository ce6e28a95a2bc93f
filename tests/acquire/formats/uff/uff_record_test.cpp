#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "support/files/uff_record.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::uff_record_test {

using test::accel_mps2;
using test::force_N;
using test::input_error_of;
using test::kUffForce;
using test::opened_uff;
using test::uff_function;
using test::UffText;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const UffText kAccel{.response = "acc", .ordinate = 12, .ordinate_unit = "g"};

TEST(UffRecord, BeginsARowWithEachForce) {
  UffText second = kAccel;
  second.response_direction = 2;
  const std::string hit = uff_function(kUffForce, 1) + uff_function(kAccel, 3) + uff_function(second, 5);
  const Record record = opened_uff(hit + hit);
  ASSERT_EQ(record.rows.size(), 2U);
  ASSERT_EQ(record.accel.size(), 2U);
  EXPECT_EQ(record.accel[0].name, "acc");
  EXPECT_EQ(record.accel[1].name, "acc 1+Y");
  EXPECT_EQ(record.fs_Hz, 1000);
  EXPECT_THAT(force_N(record, 1), ElementsAre(1, 2));
  EXPECT_THAT(accel_mps2(record, 1, 1), ElementsAre(5 * kStandardGravity_mps2, 6 * kStandardGravity_mps2));
}

TEST(UffRecord, ReadsForcesThatComeLastOrInTheirOwnGroup) {
  const Record last = opened_uff(uff_function(kAccel, 3) + uff_function(kUffForce, 1) + uff_function(kAccel, 7) +
                                 uff_function(kUffForce, 5));
  ASSERT_EQ(last.rows.size(), 2U);
  EXPECT_EQ(accel_mps2(last, 0, 0)[0], 3 * kStandardGravity_mps2);
  EXPECT_EQ(force_N(last, 1)[0], 5);
  const Record groups = opened_uff(uff_function(kUffForce, 1) + uff_function(kUffForce, 2) + uff_function(kAccel, 3) +
                                   uff_function(kAccel, 4));
  ASSERT_EQ(groups.rows.size(), 2U);
  EXPECT_EQ(accel_mps2(groups, 0, 1)[0], 4 * kStandardGravity_mps2);
}

TEST(UffRecord, NumbersPointsByTheNodeStruckOrByTheRovingSensor) {
  UffText at4 = kAccel, at9 = kAccel;
  at4.reference_node = 4;
  at9.reference_node = 9;
  const Record hammer =
      opened_uff(uff_function(kUffForce, 1) + uff_function(at4, 1) + uff_function(kUffForce, 1) + uff_function(at9, 1));
  EXPECT_THAT(hammer.points(), ElementsAre(4, 9));
  at4 = at9 = kAccel;
  at4.response_node = 4;
  at9.response_node = 9;
  const Record sensor =
      opened_uff(uff_function(kUffForce, 1) + uff_function(at4, 1) + uff_function(kUffForce, 1) + uff_function(at9, 1));
  EXPECT_THAT(sensor.points(), ElementsAre(4, 9));
}

TEST(UffRecord, NamesDrivingPoints) {
  UffText at4 = kAccel, at9 = kAccel;
  at4.response_node = at9.response_node = at9.reference_node = 9;
  at4.reference_node = 4;
  at4.reference_direction = at9.reference_direction = 3;
  const std::string hits =
      uff_function(kUffForce, 1) + uff_function(at4, 1) + uff_function(kUffForce, 1) + uff_function(at9, 1);
  EXPECT_THAT(opened_uff(hits).driving, ElementsAre(DrivingPlace{9, 0}));
}

TEST(UffRecord, TakesUnitsFromTheFileWhereFunctionsStateNone) {
  const std::string units = test::uff_units(1000, 1000);
  UffText force = kUffForce, accel = kAccel;
  force.ordinate_unit = accel.ordinate_unit = "NONE";
  const Record record = opened_uff(units + uff_function(force, 1) + uff_function(accel, 3));
  EXPECT_EQ(force_N(record)[0], 1e-3);
  EXPECT_EQ(accel_mps2(record)[0], 3e-3);
  EXPECT_THAT(record.notes, IsEmpty());
  const Record bare = opened_uff(uff_function(force, 1) + uff_function(accel, 3));
  EXPECT_THAT(test::texts(bare.notes), ElementsAre(HasSubstr("taken as N"), HasSubstr("taken as m/s^2")));
}

TEST(UffRecord, IsAmbiguousWithoutAForceFunction) {
  UffText first = kAccel, second = kAccel;
  first.response = "ch1";
  second.response = "ch2";
  first.ordinate = second.ordinate = 0;
  first.ordinate_unit = second.ordinate_unit = "NONE";
  const std::string text = uff_function(first, 1) + uff_function(second, 5);
  EXPECT_THAT(input_error_of([&] { opened_uff(text); }), HasSubstr("no force column found among ch1, ch2"));
  const Record record = opened_uff(text, {.force_channel = "ch2", .accel_channels = {"ch1"}});
  EXPECT_EQ(force_N(record)[0], 5);
}

TEST(UffRecord, RefusesUnpairedFunctionsAndOtherContents) {
  EXPECT_THAT(input_error_of([&] {
                opened_uff(uff_function(kUffForce, 1) + uff_function(kUffForce, 1) + uff_function(kAccel, 1));
              }),
              HasSubstr("2 forces and 1 responses"));
  UffText slower = kAccel;
  slower.dx = "  2.00000E-03";
  EXPECT_THAT(input_error_of([&] { opened_uff(uff_function(kUffForce, 1) + uff_function(slower, 1)); }),
              HasSubstr("differ in their sampling rate"));
  EXPECT_THAT(input_error_of([&] { opened_uff("    -1\n    15\n    -1\n"); }), HasSubstr("data sets 15 (1)"));
}

class UffWritten : public testing::Test {
 protected:
  Record example() const {
    Record record = record_in_memory(25600, {{1, 2, 3.25}, {-4, 1e-300, 6}},
                                     {{{1, 2, 1.0 / 3}, {0, 0, 1}}, {{7, 8, 9}, {-1, -2, -3}}});
    record.rows[0].point = 0;
    record.rows[1].point = 3;
    record.rows[1].run = 2;
    record.accel[0].angle_rad = 0;
    record.accel[1].angle_rad = 90 * kDegree_rad;
    record.accel[1].position_m = 0.0508;
    record.geometry = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.3, -1, 1e-7}};
    return record;
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.uff"), again_ = folder_.file("s.uff");
};

TEST_F(UffWritten, IsReadBackExactly) {
  write_uff(path_, example(), false);
  const Record record = open_record(path_);
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.fs_Hz, 25600);
  EXPECT_THAT(force_N(record, 1), ElementsAre(-4, 1e-300, 6));
  EXPECT_THAT(accel_mps2(record, 0, 0), ElementsAre(1, 2, 1.0 / 3));
  EXPECT_EQ(record.rows[1].point, 3);
  EXPECT_EQ(record.rows[1].run, 2);
  EXPECT_NEAR(*record.accel[1].angle_rad, 90 * kDegree_rad, 1e-15);  // degrees in the file
  EXPECT_EQ(record.accel[1].position_m, 0.0508);
  EXPECT_EQ(record.geometry, example().geometry);
  EXPECT_FALSE(record.continuous);
  EXPECT_THAT(record.notes, IsEmpty());
}

TEST_F(UffWritten, GivesEqualBytesWhenWrittenAgain) {
  for (const UffData data : {UffData::binary, UffData::text}) {
    write_uff(path_, example(), true, data);
    const Record read = open_record(path_);
    write_uff(again_, read, true, data);
    EXPECT_EQ(test::bytes_of(path_), test::bytes_of(again_));
  }
}

// The expected text follows the description of the layout column by column.
TEST_F(UffWritten, FollowsTheLayout) {
  Record record = record_in_memory(1000, {{1, 2}}, {{{3, -4}}});
  record.rows[0].point = 7;
  write_uff(path_, record, false, UffData::text);
  const std::string bytes = test::bytes_of(path_);
  EXPECT_THAT(bytes, HasSubstr("    -1\n    58\nhit 1\nNONE\nNONE\nNONE\npercuss; dx = 0.001\n"
                               "    1         0    0         0 force              7   0 NONE               7   0\n"
                               "         4         2         1  0.00000E+00  1.00000E-03  0.00000E+00\n"
                               "        17    0    0    0 Time                 s                   \n"
                               "        13    0    0    0 Force                N                   \n"
                               "         0    0    0    0 NONE                 NONE                \n"
                               "         0    0    0    0 NONE                 NONE                \n"
                               "  1.000000000000E+00  2.000000000000E+00\n    -1\n"));
  EXPECT_TRUE(bytes.starts_with("    -1\n   151\n"));
  write_uff(path_, record, true);
  EXPECT_THAT(test::bytes_of(path_),
              HasSubstr("    58b     1     2          11          16     0     0           0           0\nhit 1\n"));
}

TEST_F(UffWritten, IsRefusedWhenTruncatedAnywhere) {
  Record record = record_in_memory(1000, {{1, 2}}, {{{3, -4}}});
  for (const UffData data : {UffData::binary, UffData::text}) {
    write_uff(path_, record, true, data);
    const std::string bytes = test::bytes_of(path_);
    for (std::size_t cut = 0; cut + 1 < bytes.size(); ++cut) {  // the last line may lack its end
      try {
        opened_uff(bytes.substr(0, cut));
        ADD_FAILURE() << "read with " << cut << " of " << bytes.size() << " bytes";
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(UffWritten, SurvivesMutations) {
  write_uff(path_, example(), true, UffData::text);
  const std::string text = test::bytes_of(path_);
  write_uff(path_, example(), true);
  const std::string binary = test::bytes_of(path_);
  std::mt19937 random(58);
  int read = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = i % 2 == 0 ? text : binary;
    for (int n = 0; n < 1 + i % 4; ++n) damaged[random() % damaged.size()] = "0123456789-+. Eb\n\xFF"[random() % 18];
    try {
      const Record record = opened_uff(damaged);
      for (std::size_t row = 0; row < record.rows.size(); ++row) {
        for (const double sample : force_N(record, row)) ASSERT_TRUE(std::isfinite(sample));
        for (std::size_t channel = 0; channel < record.accel.size(); ++channel) {
          for (const double sample : accel_mps2(record, channel, row)) ASSERT_TRUE(std::isfinite(sample));
        }
      }
      ++read;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(read, 500);  // mutations that matter always or never would test little
  EXPECT_GT(refused, 500);
}

}  // namespace percuss::acquire::uff_record_test
