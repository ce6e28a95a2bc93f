#include "identify/classify/asymmetry_split.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::asymmetry_split_test {

using std::numbers::pi;

constexpr double kRounding = 1e-12;

SensorPair sensors_at(double first_deg, double second_deg) {
  return {.first = 0, .second = 1, .first_rad = first_deg * kDegree_rad, .second_rad = second_deg * kDegree_rad};
}

Mode mode_with_plane(int n, double plane_deg, const SensorPair& sensors, double scale = 1, double std = 1e-4) {
  Mode mode{.pole = {1900, 0.003}, .freq_std_Hz = 0.03};
  const double plane = plane_deg * kDegree_rad;
  mode.residues = {{.channel = 0, .value = scale * std::cos(n * (sensors.first_rad - plane)), .std = std},
                   {.channel = 1, .value = scale * std::cos(n * (sensors.second_rad - plane)), .std = std}};
  return mode;
}

TEST(PlaneFromSensors, IsTheBendingPlane) {
  for (const double plane_deg : {0.0, 12.0, 45.0, 90.0, 135.0, 179.0}) {
    const SensorPair sensors = sensors_at(0, 90);
    const auto plane = plane_from_sensors(mode_with_plane(1, plane_deg, sensors, -3), sensors, 1, 0);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(std::remainder(plane->plane_rad - plane_deg * kDegree_rad, pi), 0, kRounding) << plane_deg;
  }
}

TEST(PlaneFromSensors, IsTheHoopPlaneForOtherSensorAngles) {
  for (const double plane_deg : {1.0, 20.0, 50.0, 80.0}) {
    const SensorPair sensors = sensors_at(10, 60);
    const auto plane = plane_from_sensors(mode_with_plane(2, plane_deg, sensors), sensors, 2, 0);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->plane_rad, plane_deg * kDegree_rad, kRounding);
  }
}

TEST(PlaneFromSensors, IsUnknownForHoopModesAtARightAngle) {
  const SensorPair sensors = sensors_at(0, 90);
  EXPECT_FALSE(plane_from_sensors(mode_with_plane(2, 20, sensors), sensors, 2, 0));
  EXPECT_FALSE(plane_from_sensors(mode_with_plane(1, 20, sensors, 0), sensors, 1, 0));
}

TEST(PlaneFromSensors, HasTrueStandardDeviations) {
  constexpr double kStd = 0.02, kScatter = 0.1;  // 3.5 times 2.9 %: a standard deviation from 600 trials
  constexpr std::size_t kTrials = 600;
  const SensorPair sensors = sensors_at(0, 70);
  double squares = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    std::vector<double> noise(2);
    synth::RandomStream({5, trial}).add_normal(kStd, noise);
    Mode mode = mode_with_plane(1, 30, sensors, 1, kStd);
    for (std::size_t c = 0; c < 2; ++c) mode.residues[c].value += noise[c];
    squares += std::pow(plane_from_sensors(mode, sensors, 1, 0)->plane_rad - 30 * kDegree_rad, 2);
  }
  const double scatter_std = std::sqrt(squares / kTrials);
  EXPECT_NEAR(plane_from_sensors(mode_with_plane(1, 30, sensors, 1, kStd), sensors, 1, 0)->std_rad / scatter_std, 1,
              kScatter);
}

TEST(PlaneFromSensors, IncludesTheSensorsPlacementError) {
  // An error ε of both angles turns the plane by ε. Independent errors of standard deviation ε turn it by ε/√2, for
  // sensors 90° apart and a plane midway between them.
  const SensorPair sensors = sensors_at(0, 90);
  EXPECT_NEAR(plane_from_sensors(mode_with_plane(1, 45, sensors, 1, 0), sensors, 1, 0.035)->std_rad,
              0.035 / std::sqrt(2.0), kRounding);
}

struct Pair {
  SplitMode first{.partner = 1, .separation_Hz = 12, .first = true}, second{.partner = 0, .separation_Hz = 12};
};

Pair described(double between_deg, int order, double std_rad = 0.01) {
  Pair pair;
  const Mode mode = mode_with_plane(1, 20, sensors_at(0, 90));
  describe_split(mode, mode, PatternPlane{0.1, std_rad, order},
                 PatternPlane{0.1 + between_deg * kDegree_rad, std_rad, order}, pair.first, pair.second);
  return pair;
}

TEST(SplitModePlanes, IsFromAsymmetryWhereThePlanesDiffer) {
  EXPECT_EQ(described(45, 2).first.planes->cause, SplitCause::asymmetry);
  EXPECT_EQ(described(90, 1).first.planes->cause, SplitCause::asymmetry);
  EXPECT_EQ(described(0, 2).first.planes->cause, SplitCause::coupled);
  EXPECT_EQ(described(22, 2).first.planes->cause, SplitCause::unclear);
  EXPECT_EQ(described(45, 2, 0.3).first.planes->cause, SplitCause::unclear);
  EXPECT_NEAR(described(130, 2).second.planes->between_rad, 40 * kDegree_rad, kRounding);
  EXPECT_NEAR(described(45, 2).first.planes->between_std_rad, 0.01 * std::sqrt(2.0), kRounding);
}

TEST(SplitModePlanes, QuotesTheFirstUnlessHidden) {
  const SensorPair sensors = sensors_at(0, 90);
  for (const double scale : {1.0, 0.2, 0.02}) {
    Pair pair;
    describe_split(mode_with_plane(2, 20, sensors, scale), mode_with_plane(2, 65, sensors), {}, {}, pair.first,
                   pair.second);
    EXPECT_EQ(pair.first.quoted, scale > 0.1);  // hidden where 20 dB lower
    EXPECT_NE(pair.first.quoted, pair.second.quoted);
    EXPECT_FALSE(pair.first.planes);
    EXPECT_NEAR(pair.first.separation_std_Hz, 0.03 * std::sqrt(2.0), kRounding);
  }
}

TEST(SplitModePlanes, IsPartOfTheClassification) {
  const SensorPair sensors = sensors_at(0, 90);
  std::vector<Mode> modes{mode_with_plane(1, 20, sensors), mode_with_plane(1, 110, sensors)};
  modes[0].pole.freq_Hz = 169;
  modes[1].pole.freq_Hz = 171;
  const auto classifications = classify(modes, sensors, std::vector<std::optional<double>>(2));
  ASSERT_TRUE(classifications[0].split_mode && classifications[1].split_mode);
  ASSERT_TRUE(classifications[0].split_mode->planes);
  EXPECT_EQ(classifications[0].split_mode->planes->cause, SplitCause::asymmetry);
  EXPECT_NEAR(classifications[1].split_mode->planes->own.plane_rad, 110 * kDegree_rad, 1e-9);
  EXPECT_TRUE(classifications[0].split_mode->quoted);
}

}  // namespace percuss::identify::asymmetry_split_test
