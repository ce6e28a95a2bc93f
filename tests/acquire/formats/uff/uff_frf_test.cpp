#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "acquire/formats/uff/read_frf_uff.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/formats/uff/write_frf_uff.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::uff_frf_test {

using test::csv_bytes;
using test::input_error_of;
using test::UffText;
using testing::ElementsAre;
using testing::HasSubstr;

// Two complex lines (x, −x) and (2x, 0) at 10 and 12 Hz.
std::string frf_text(const UffText& set, double x) { return test::uff_frf(test::uff_frf_header(set), x); }

FrfRecord read(const std::string& text, const FrfReadOptions& options = {}) {
  const FileBytes bytes = csv_bytes(text);
  auto stored = read_frf_uff(bytes, read_uff_contents(bytes), options.kind.has_value());
  EXPECT_TRUE(stored.has_value());
  return to_accelerances(std::move(stored).value(), options);
}

TEST(UffFrf, RefusesNegativeNodesOfPoints) {
  UffText set{.reference_node = -2};
  EXPECT_THAT(input_error_of([&] { read(frf_text(set, 1)); }), HasSubstr("-2 is not a point number (x.csv: line 3)"));
}

TEST(UffFrf, ReadsTheUnitOfTheFrequencies) {
  UffText set{.abscissa_unit = "kHz", .ordinate_unit = "m/s^2", .denominator_unit = "N"};
  EXPECT_NEAR(read(frf_text(set, 1)).lines.df_Hz(), 2000, 1e-6);
}

TEST(UffFrf, MakesPointsOfStruckNodesAndChannelsOfResponses) {
  std::string text;
  for (const int node : {4, 9}) {
    for (const int direction : {2, 3}) {
      UffText set{.response_node = 1,
                  .response_direction = direction,
                  .reference_node = node,
                  .ordinate_unit = "g",
                  .denominator_unit = "N"};
      text += frf_text(set, node + 0.1 * direction);
    }
  }
  const FrfRecord record = read(text);
  ASSERT_EQ(record.frfs.size(), 4U);
  EXPECT_EQ(record.frfs[3].point, 9);
  EXPECT_EQ(record.frfs[3].channel, 1U);
  EXPECT_EQ(record.lines.first, 5U);
  EXPECT_NEAR(record.lines.df_Hz(), 2, 1e-12);
  const double g = kStandardGravity_mps2;
  EXPECT_DOUBLE_EQ(record.frfs[3].frf.value[0].real(), 9.3 * g);
  EXPECT_DOUBLE_EQ(record.frfs[3].frf.value[0].imag(), -9.3 * g);
  EXPECT_EQ(record.kind, FrfKind::accelerance);
}

TEST(UffFrf, ChecksAStatedSpacing) {
  const FrfReadOptions other{.read = {.df_Hz = 2.1}};
  EXPECT_EQ(read(frf_text({}, 1), {.read = {.df_Hz = 2}}).lines.df_Hz(), 2);
  EXPECT_THAT(input_error_of([&] { read(frf_text({}, 1), other); }), HasSubstr("contradicts the frequencies"));
}

// A driving point has response and reference at the same node, along the same line.
TEST(UffFrf, NamesDrivingPoints) {
  std::string text;
  for (const int node : {4, 9}) {
    for (const int direction : {2, 3}) {
      text += frf_text(
          {.response_node = 9, .response_direction = direction, .reference_node = node, .reference_direction = 3}, 1);
    }
  }
  EXPECT_THAT(read(text).driving, ElementsAre(DrivingPlace{9, 1}));
  FrfReadOptions second;
  second.read.accel_channels = {"2"};
  EXPECT_THAT(read(text, second).driving, ElementsAre(DrivingPlace{9, 0}));
  UffText set{.response_node = 9, .response_direction = 3, .reference_node = 9, .reference_direction = -3};
  EXPECT_THAT(read(frf_text(set, 1)).driving, ElementsAre(DrivingPlace{9, 0}))
      << "struck against the direction of the sensor: the sign of the FRF is changed";
  set.reference_direction = 1;
  EXPECT_TRUE(read(frf_text(set, 1)).driving.empty()) << "struck across the direction of the sensor";
}

TEST(UffFrf, MakesPointsOfResponsesOfARovingSensor) {
  std::string text;
  for (const int node : {7, 3, 5}) text += frf_text({.response_node = node, .reference_node = 1}, node);
  const FrfRecord record = read(text);
  ASSERT_EQ(record.frfs.size(), 3U);
  ASSERT_EQ(record.accel.size(), 1U);
  EXPECT_EQ(record.frfs[0].point, 3);
  EXPECT_EQ(record.frfs[0].frf.value[0].real(), 3);
}

TEST(UffFrf, TakesUnitsAndKindFromAxesOrTheFilesSystem) {
  const UffText velocity{.ordinate = 11, .ordinate_unit = "mm/s", .denominator_unit = "N"};
  EXPECT_EQ(read(frf_text(velocity, 1)).kind, FrfKind::mobility);
  EXPECT_NEAR(read(frf_text(velocity, 1)).accel[0].to_SI, 1e-3, 1e-18);
  const std::string units = test::uff_units(1000, 1000);
  const FrfRecord receptance = read(units + frf_text({.ordinate = 8}, 1));
  EXPECT_EQ(receptance.kind, FrfKind::receptance);
  EXPECT_NEAR(receptance.accel[0].to_SI, 1, 1e-12) << "mm per mN";
}

TEST(UffFrf, RefusesGapsAndOtherLines) {
  const auto at = [](int point, int channel) {
    return frf_text({.response = "s" + std::to_string(channel), .reference_node = point}, 1);
  };
  EXPECT_THAT(input_error_of([&] { read(at(1, 1) + at(1, 2) + at(2, 1)); }),
              HasSubstr("3 FRFs, but 2 channels at 2 points need 4"));
  EXPECT_THAT(input_error_of([&] { read(at(1, 1) + at(1, 1)); }), HasSubstr("two FRFs of channel 1"));
  std::string other = at(2, 1);
  other.replace(other.find("  2.00000E+00"), 13, "  1.00000E+00");
  EXPECT_THAT(input_error_of([&] { read(at(1, 1) + other); }), HasSubstr("other lines"));
}

TEST(UffFrf, YieldsToTimeRecordsUnlessForced) {
  const UffText time{.values = 2};
  const FileBytes bytes = csv_bytes(frf_text({}, 1) + time.text("  1.00000E+00  2.00000E+00\n"));
  EXPECT_FALSE(read_frf_uff(bytes, read_uff_contents(bytes), false).has_value());
  EXPECT_TRUE(read_frf_uff(bytes, read_uff_contents(bytes), true).has_value());
}

TEST(UffFrf, IsWrittenWithCoherenceAndReadBackExactly) {
  FrfRecord record;
  record.files.push_back({.path = "x"});
  record.lines = {.fs_Hz = 1000.0 / 3, .samples = 100, .first = 3, .count = 2};
  record.accel.push_back({.name = "accel 1", .angle_rad = 0.5});
  for (const int point : {0, 2}) {
    Frf frf{.value = {{1.0 / 3, 2}, {3, -4}}, .coherence = {0.5, 0.8}, .averages = 5};
    // σ² = (1 − γ²)/γ² · |H|²/(n − 1)
    frf.std = {std::sqrt(0.5 / 0.5 / 4) * std::abs(frf.value[0]), std::sqrt(0.2 / 0.8 / 4) * 5};
    record.frfs.push_back({.point = point, .channel = 0, .frf = frf});
  }
  record.geometry = {{0, 0, 0}, {0.25, 0, 0}, {0.5, 0, 1e-9}};
  const test::ScratchFolder folder;
  write_frf_record_uff(folder.file("f.uff"), record, FrfKind::accelerance, false);
  const auto again = std::get<FrfRecord>(open_measurement(folder.file("f.uff")));
  ASSERT_EQ(again.frfs.size(), 2U);
  EXPECT_EQ(again.frfs[1].point, 2);
  EXPECT_EQ(again.frfs[0].frf.value, record.frfs[0].frf.value);
  EXPECT_EQ(again.frfs[0].frf.coherence, record.frfs[0].frf.coherence);
  EXPECT_NEAR(again.frfs[0].frf.std[1], record.frfs[0].frf.std[1], 1e-12);  // rounding
  EXPECT_NEAR(again.lines.df_Hz(), 10.0 / 3, 1e-14);                        // rounding
  EXPECT_EQ(again.lines.first, 3U);
  EXPECT_NEAR(*again.accel[0].angle_rad, 0.5, 1e-9);  // degrees with ten digits in the file
  EXPECT_EQ(again.geometry, record.geometry);
}

}  // namespace percuss::acquire::uff_frf_test
