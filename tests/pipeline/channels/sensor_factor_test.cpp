#include "pipeline/channels/sensor_factor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace percuss::pipeline::sensor_factor_test {

using std::numbers::pi;

// A tube struck at `blow_deg`, with sensors at 0° and 90° + `misplaced_deg`, by (6.1) and (6.2). Without `plane_deg`,
// the tube is round, and its bending modes lie in the plane of the blow.
std::vector<SensorRatio> tube(double blow_deg, double misplaced_deg = 0, std::optional<double> plane_deg = {}) {
  const double second_rad = (90 + misplaced_deg) / kRadian_deg, blow_rad = blow_deg / kRadian_deg;
  std::vector<SensorRatio> out;
  const auto add = [&](double freq_Hz, int waves, double angle_rad) {
    const double ratio = std::cos(waves * (second_rad - angle_rad)) / std::cos(waves * angle_rad);
    out.push_back({freq_Hz, ratio, 1e-3 * std::abs(ratio) / (1 + ratio * ratio)});
  };
  for (const double freq_Hz : {170.0, 580.0, 1200.0}) {
    add(freq_Hz, 1, plane_deg ? *plane_deg / kRadian_deg : blow_rad);
    if (plane_deg) add(1.01 * freq_Hz, 1, *plane_deg / kRadian_deg + pi / 2);
  }
  for (const double freq_Hz : {1850.0, 2600.0}) add(freq_Hz, 2, blow_rad);
  return out;
}

std::vector<SensorRatio> scaled(std::vector<SensorRatio> ratios, double factor) {
  for (SensorRatio& one : ratios) {
    one.ratio *= factor;
    one.angle_std_rad = 1e-3 * std::abs(one.ratio) / (1 + one.ratio * one.ratio);
  }
  return ratios;
}

constexpr std::array kFactors{5.0, 20.0, 100.0, 0.2, 0.05, 0.01};

TEST(SensorFactor, IsFoundForRoundTubes) {
  for (const double factor : kFactors) {
    for (const double blow_deg : {20.0, 25.0, 30.0, 60.0, 65.0, 70.0}) {
      const auto found = sensor_factor(scaled(tube(blow_deg), factor));
      ASSERT_TRUE(found) << factor << ", " << blow_deg << "°";
      EXPECT_NEAR(found->factor / factor, 1, 1e-9) << blow_deg << "°";
      EXPECT_EQ(found->hoop_ratios.size(), 2U);
    }
  }
}

TEST(SensorFactor, IsFoundForTubesWithTwoPlanes) {
  for (const double factor : kFactors) {
    for (const double plane_deg : {20.0, 25.0, 30.0, 60.0, 65.0, 70.0}) {
      const auto found = sensor_factor(scaled(tube(12, 0, plane_deg), factor));
      ASSERT_TRUE(found) << factor << ", " << plane_deg << "°";
      EXPECT_NEAR(found->factor / factor, 1, 1e-9) << plane_deg << "°";
    }
  }
}

// Near 45° the sensors are at nodes of the hoop modes, whose ratio is then any number.
TEST(SensorFactor, IsNotFoundOfRightScalesForAnyBlow) {
  for (const double misplaced_deg : {-5.0, -3.0, 0.0, 3.0, 5.0}) {
    for (double blow_deg = 0.3; blow_deg < 180; ++blow_deg) {
      EXPECT_FALSE(sensor_factor(tube(blow_deg, misplaced_deg))) << blow_deg << "°, " << misplaced_deg << "°";
      for (double plane_deg = 0.2; plane_deg < 90; plane_deg += 5) {
        EXPECT_FALSE(sensor_factor(tube(blow_deg, misplaced_deg, plane_deg)))
            << blow_deg << "°, " << misplaced_deg << "°, " << plane_deg << "°";
      }
    }
  }
}

// Bending in planes near the axis of the second sensor has large ratios of either sign.
TEST(SensorFactor, IsNotFoundWhereNoHoopModeShowsIt) {
  const auto of = [](const std::vector<double>& ratios) {
    std::vector<SensorRatio> out;
    double freq_Hz = 170;
    for (const double ratio : ratios) {
      out.push_back({freq_Hz, ratio, 1e-3 * std::abs(ratio) / (1 + ratio * ratio)});
      freq_Hz *= 1.8;
    }
    return sensor_factor(out);
  };
  EXPECT_FALSE(of({-100, -100, -100, -101, -99})) << "hoop modes alone, or bending in one plane";
  EXPECT_FALSE(of({11.4, 7, 30, -20, -19.5})) << "planes that scatter";
  EXPECT_FALSE(of({7.3, 7.3, 7.2, -20, -1})) << "one mode, and a hoop mode of right scales";
  EXPECT_FALSE(of({0.05, 0.05, 0.05, -20, -20.2})) << "another plane, at right angles";
  EXPECT_TRUE(of({7.3, 7.3, 7.2, -20, -20.2}));
}

// A ratio whose ± is large shows no factor.
TEST(SensorFactor, NeedsClearRatios) {
  std::vector<SensorRatio> ratios = scaled(tube(20), 100);
  EXPECT_TRUE(sensor_factor(ratios));
  for (SensorRatio& one : ratios) one.angle_std_rad *= 200;  // ± 20 %
  EXPECT_FALSE(sensor_factor(ratios));
}

}  // namespace percuss::pipeline::sensor_factor_test
