#include "pipeline/warnings/tube_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percuss::pipeline::tube_warnings_test {

using identify::ModeClassification;
using identify::ModeType;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Found {
  double freq_Hz = 0, ratio = 0;
  ModeType type = ModeType::bending;
  int order = 0;
};

acquire::Record two_sensors(double apart_rad) {
  acquire::Record record;
  record.accel = {{.name = "A", .angle_rad = 0}, {.name = "B", .angle_rad = apart_rad}};
  return record;
}

std::vector<Warning> warnings_of(const std::vector<Found>& found, const acquire::Record& record, bool complete = true) {
  std::vector<identify::Mode> modes;
  std::vector<ModeClassification> types;
  for (const Found& one : found) {
    modes.push_back({.pole = {.freq_Hz = one.freq_Hz, .damping_ratio = 0.005}});
    types.push_back({.type = one.type,
                     .order = one.order,
                     .confidence = 0.98,
                     .alternative = {},
                     .overlay_dB = {},
                     .ratio = one.ratio,
                     .ratio_std = std::min(1e-3, 0.03 * std::abs(one.ratio)),
                     .split_mode = {}});
  }
  return tube_warnings(record, modes, types, {}, complete);
}

std::vector<Warning> warnings_of(const std::vector<Found>& found, double apart_rad = std::numbers::pi / 2,
                                 bool complete = true) {
  return warnings_of(found, two_sensors(apart_rad), complete);
}

// Struck at 20° from the first sensor: bending has tan 20° = 0.364, hoop −1.
const std::vector<Found> kBat{{182, 0.364, ModeType::bending, 1},
                              {622, 0.366, ModeType::bending, 2},
                              {1265, 0.361, ModeType::bending, 3},
                              {1900, -1.01, ModeType::hoop, 1},
                              {2650, -0.99, ModeType::hoop, 2}};

TEST(TubeWarnings, SayNothingOfABat) { EXPECT_THAT(warnings_of(kBat), IsEmpty()); }

TEST(TubeWarnings, NameHitsHalfwayBetweenTheSensors) {
  std::vector<Found> at_135 = kBat, at_45 = kBat;
  for (Found& one : at_135) one.ratio = -1.02;
  for (Found& one : at_45) one.ratio = 1.03;
  EXPECT_THAT(warnings_of(at_135), ElementsAre(Field(&Warning::code, "midway_hit")));
  EXPECT_THAT(warnings_of(at_45), ElementsAre(Field(&Warning::code, "midway_hit")));
  // A split hoop mode and one more: too few modes to tell.
  EXPECT_THAT(
      warnings_of({{1900, -1, ModeType::hoop, 1}, {1912, -1, ModeType::hoop, 1}, {2650, -1, ModeType::hoop, 2}}),
      IsEmpty());
}

TEST(TubeWarnings, AskForAReversedSensorWhereHoopModesMoveBothAlike) {
  std::vector<Found> reversed = kBat;
  for (Found& one : reversed) one.ratio *= -1;
  const std::vector<Warning> warnings = warnings_of(reversed);
  EXPECT_THAT(warnings, ElementsAre(Field(&Warning::code, "reversed")));
  EXPECT_THAT(warnings.front().message, HasSubstr(" in 2 modes"));
  // One mode alone may be a bending mode in another plane.
  std::vector<Found> one_alike = reversed;
  one_alike.pop_back();
  EXPECT_THAT(warnings_of(one_alike), IsEmpty());
}

// In line with sensor 1, hoop modes move sensor 2 against it by nature, and bending modes hardly move sensor 2.
TEST(TubeWarnings, SayNothingOfABatStruckInLineWithASensor) {
  for (const double tilt : {2e-3, -1e-3, 0.02, 600.0}) {
    EXPECT_THAT(warnings_of({{182, tilt, ModeType::bending, 1},
                             {622, -0.5 * tilt, ModeType::bending, 2},
                             {1265, 1.5 * tilt, ModeType::bending, 3},
                             {1900, -1.01, ModeType::hoop, 1},
                             {1912, -1.01, ModeType::hoop, 1},
                             {2650, -0.99, ModeType::hoop, 2},
                             {2659, -0.99, ModeType::hoop, 2}}),
                IsEmpty())
        << tilt;
  }
}

// The ratios of the two planes of a wooden bat, 5.5° from the sensors: 0.096 and −10.4.
TEST(TubeWarnings, TakeTheGrainOfAWoodenBatForNoUnit) {
  std::vector<Found> wood;
  for (int order = 1; order <= 4; ++order) {
    const double freq_Hz = 148 * order * order * 0.85;
    wood.push_back({freq_Hz, 0.096, ModeType::bending, order});
    wood.push_back({1.007 * freq_Hz, -10.4, ModeType::bending, order});
  }
  EXPECT_THAT(warnings_of(wood), Not(Contains(Field(&Warning::code, "units_differ"))));
  std::vector<Found> second_plane;
  for (std::size_t i = 1; i < wood.size(); i += 2) second_plane.push_back(wood[i]);
  EXPECT_THAT(warnings_of(second_plane), Not(Contains(Field(&Warning::code, "units_differ"))));
}

TEST(TubeWarnings, NameAReversedSensorOfABatThatBendsInTwoPlanes) {
  const std::vector<Found> reversed{{172, -0.47, ModeType::bending, 1}, {174, 2.1, ModeType::bending, 1},
                                    {588, -0.45, ModeType::bending, 2}, {595, 2.2, ModeType::bending, 2},
                                    {1850, 1.01, ModeType::unknown, 0}, {1865, 1.01, ModeType::unknown, 0},
                                    {2620, 0.99, ModeType::unknown, 0}, {2644, 0.99, ModeType::unknown, 0}};
  const std::vector<Warning> warnings = warnings_of(reversed);
  ASSERT_THAT(warnings, ElementsAre(Field(&Warning::code, "reversed")));
  EXPECT_THAT(warnings.front().message, HasSubstr("A and B move alike by the same amount in 4 modes"));
}

// Sensors at other places along the tube have other ratios: nothing is said.
TEST(TubeWarnings, CompareSensorsAtOnePlaceOnly) {
  std::vector<Found> reversed = kBat;
  for (Found& one : reversed) one.ratio *= -1;
  acquire::Record record = two_sensors(std::numbers::pi / 2);
  record.accel[0].position_m = 0.05;
  record.accel[1].position_m = 0.12;
  EXPECT_THAT(warnings_of(reversed, record), Not(Contains(Field(&Warning::code, "reversed"))));
  record.accel[1].position_m = 0.05;
  EXPECT_THAT(warnings_of(reversed, record), Contains(Field(&Warning::code, "reversed")));
}

TEST(TubeWarnings, NameMillimetresThatHoopModesShow) {
  for (const double factor : {1000.0, 1e-3}) {
    std::vector<Found> scaled = kBat;
    for (Found& one : scaled) one.ratio *= factor;
    const std::vector<Warning> warnings = warnings_of(scaled);
    ASSERT_THAT(warnings, ElementsAre(Field(&Warning::code, "units_differ"))) << factor;
    EXPECT_THAT(warnings.front().message, HasSubstr("is 1000 times "));
  }
}

TEST(TubeWarnings, NameAUnitThatHoopModesContradict) {
  std::vector<Found> second = kBat, first = kBat;
  for (Found& one : second) one.ratio *= 9.81;
  for (Found& one : first) one.ratio /= 9.81;
  EXPECT_THAT(warnings_of(second), ElementsAre(Field(&Warning::code, "units_differ")));
  EXPECT_THAT(warnings_of(first), ElementsAre(Field(&Warning::code, "units_differ")));
}

// Sensors of other gains: the message states the measured ratio of the two hoop modes, 9.1.
TEST(TubeWarnings, StateTheMeasuredRatioOfTheUnits) {
  std::vector<Found> second = kBat, first = kBat;
  for (Found& one : second) one.ratio *= 9.1;
  for (Found& one : first) one.ratio /= 9.1;
  for (const auto& ratios : {first, second}) {
    const std::vector<Warning> warnings = warnings_of(ratios);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings.front().message, HasSubstr(" is 9.1 times "));
  }
}

// Two accelerometers of 10 and 100 mV/g whose sensitivities are stated in the wrong order: a factor of 100.
TEST(TubeWarnings, AskForExchangedSensitivitiesWhereHoopModesShowAFactorOfNoUnit) {
  for (const double factor : {100.0, 0.01, 20.0, 0.05}) {
    std::vector<Found> exchanged = kBat;
    for (Found& one : exchanged) one.ratio *= factor;
    const std::vector<Warning> warnings = warnings_of(exchanged);
    ASSERT_THAT(warnings, ElementsAre(Field(&Warning::code, "units_differ"))) << factor;
    const std::string larger = factor > 1 ? "B" : "A", other = factor > 1 ? "A" : "B";
    const std::string size = std::abs(std::log(factor)) > std::log(50) ? "100" : "20";
    EXPECT_THAT(warnings.front().message,
                HasSubstr(larger + " is " + size + " times " + other + ", with the opposite sign, in 2 modes"));
    EXPECT_THAT(warnings.front().message, HasSubstr("are the sensitivities exchanged"));
    EXPECT_THAT(warnings.front().options, Contains("accel_sensitivity"));
  }
}

// At 45°, the sensors are at the nodes of the hoop modes: an angle wrong by 2° gives these a ratio of −3.4.
TEST(TubeWarnings, TakeHoopModesAtTheirNodesForNoFactor) {
  const std::vector<Found> midway{{182, 1.05, ModeType::bending, 1},
                                  {622, 1.04, ModeType::bending, 2},
                                  {1265, 1.06, ModeType::bending, 3},
                                  {1900, -3.4, ModeType::bending, 4},
                                  {2650, -3.5, ModeType::bending, 5}};
  EXPECT_THAT(warnings_of(midway), Not(Contains(Field(&Warning::code, "units_differ"))));
}

TEST(TubeWarnings, NameAnglesThatTheModesContradict) {
  EXPECT_THAT(warnings_of(kBat, std::numbers::pi), ElementsAre(Field(&Warning::code, "angles_contradicted")));
}

// Hits on the node of the first bending mode: 622 Hz is taken for it.
TEST(TubeWarnings, NameABendingModeThatIsProbablyMissing) {
  const std::vector<Found> without_first{
      {622, 0.366, ModeType::bending, 1}, {1265, 0.361, ModeType::bending, 2}, {1900, -1.01, ModeType::hoop, 1}};
  EXPECT_THAT(warnings_of(without_first), ElementsAre(Field(&Warning::code, "order_missing")));
  EXPECT_THAT(warnings_of(without_first, std::numbers::pi / 2, false), IsEmpty()) << "the user chose the modes";
}

}  // namespace percuss::pipeline::tube_warnings_test
