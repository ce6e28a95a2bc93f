#include "acquire/calibrate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/force_row.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::calibrate_test {

constexpr double kFs_Hz = 25600;
constexpr double kMass_kg = 4.2;

struct Bench {
  double scale = 0.0102;  // N per unit of the force channel
  double offset = 0;      // of the force channel, in its unit
  double accel_offset = 0;
  double noise = 0;  // standard deviation of the force and of mass · acceleration, as a fraction of 300 N
  double accel_sign = 1;
  std::vector<double> peaks_N = {300, 180, 420};
};

/// Hits on a free mass, one per row. The force channel is force/scale + offset, the acceleration ±force/mass + offset.
Record free_mass(const Bench& bench) {
  std::vector<std::vector<double>> force;
  std::vector<std::vector<std::vector<double>>> accel;
  for (std::size_t h = 0; h < bench.peaks_N.size(); ++h) {
    std::vector<double> x(6000);
    test::add_filtered_haversine(x, 300.3 + static_cast<double>(h), 30, bench.peaks_N[h]);
    auto f = x, a = x;
    test::add_noise(f, bench.noise * 300, 2 * h);
    test::add_noise(a, bench.noise * 300, 2 * h + 1);
    for (double& value : f) value = value / bench.scale + bench.offset;
    for (double& value : a) value = bench.accel_sign * value / kMass_kg + bench.accel_offset;
    force.push_back(f);
    accel.push_back({a});
  }
  return record_in_memory(kFs_Hz, force, accel);
}

TEST(Calibrate, IsExactOnAFreeMass) {
  const Calibration found = calibrate(free_mass({}), kMass_kg);
  constexpr double kRounding = 1e-12;  // both signals ring alike before the pulse, so that their offsets cancel
  EXPECT_LE(std::abs(found.scale / 0.0102 - 1), kRounding);
  ASSERT_EQ(found.hits.size(), 3U);
  for (std::size_t h = 0; h < 3; ++h) {
    EXPECT_EQ(found.hits[h].index, h);
    EXPECT_TRUE(found.hits[h].used);
    EXPECT_GE(found.hits[h].samples, 14U);  // half of a haversine of 30 samples stands above half of its peak
    EXPECT_LE(found.hits[h].samples, 16U);
  }
}

TEST(Calibrate, NumbersHitsAsTheRecordDoes) {
  const Calibration found = calibrate(free_mass({.peaks_N = {300, 0, 420}}), kMass_kg);
  ASSERT_EQ(found.hits.size(), 2U);  // the second row has no pulse
  EXPECT_EQ(found.hits[0].index, 0U);
  EXPECT_EQ(found.hits[1].index, 2U);
}

TEST(Calibrate, SatisfiesNewtonsLaw) {
  constexpr double kRounding = 1e-12;  // of sums of 15 products
  for (const double scale : {0.0102, -0.00684, 1.0, 1e-30, -1e30}) {
    const Calibration found = calibrate(free_mass({.scale = scale}), kMass_kg);
    EXPECT_LE(std::abs(found.scale / scale - 1), kRounding) << scale;  // both ring alike: force = mass · acceleration
    EXPECT_LE(found.scale_std, kRounding * std::abs(scale)) << scale;
    for (const CalibrationHit& hit : found.hits) {
      EXPECT_LE(std::abs(hit.scale / scale - 1), kRounding);
      // The filter rings in the 8 samples that give the offset of the acceleration: 3e-4 of the peak at most.
      EXPECT_LE(std::abs(hit.peak_accel_mps2 * kMass_kg / (hit.peak_force * scale) - 1), 1e-3);
    }
  }
}

TEST(Calibrate, IgnoresOffsetsAndTheAccelerometersDirection) {
  constexpr double kRounding = 1e-11;  // of values beside offsets ten times as large
  const Bench offset{.offset = -3e5, .accel_offset = 700};
  EXPECT_LE(std::abs(calibrate(free_mass(offset), kMass_kg).scale / 0.0102 - 1), kRounding);
  const Bench turned{.accel_sign = -1};
  const Calibration found = calibrate(free_mass(turned), kMass_kg);
  EXPECT_LE(std::abs(found.scale / 0.0102 - 1), kRounding);
  EXPECT_LE(found.hits[0].peak_accel_mps2, -60);  // 300 N on 4.2 kg, as recorded
}

TEST(Calibrate, IsProportionalToTheMass) {
  const Record record = free_mass({});
  EXPECT_DOUBLE_EQ(calibrate(record, 2 * kMass_kg).scale, 2 * calibrate(record, kMass_kg).scale);
}

TEST(Calibrate, LeavesWeakHitsOut) {
  const Calibration found = calibrate(free_mass({.peaks_N = {300, 50, 250}}), kMass_kg);
  ASSERT_EQ(found.hits.size(), 3U);
  EXPECT_TRUE(found.hits[0].used);
  EXPECT_FALSE(found.hits[1].used);  // below a fifth of the largest
  EXPECT_TRUE(found.hits[2].used);
}

TEST(Calibrate, HasTheExpectedStandardDeviation) {
  const std::vector<double> peaks(20, 300);
  const Calibration found = calibrate(free_mass({.noise = 0.01, .peaks_N = peaks}), kMass_kg);
  // Both channels have the same noise. 15 samples of each hit exceed half of the peak; their mean square is at least
  // 0.6 of the peak's square. Each offset is a mean of 8 samples. An offset changes the scale by its own size times
  // Σx/Σx² of the 15 samples, hence the factor (mean x)²/(mean x²)², about 1/0.75.
  const double expected = 0.01 * std::sqrt(2 * (1 / (15 * 0.6) + 1 / (8 * 0.75))) / std::sqrt(20.0);
  EXPECT_LE(std::abs(found.scale / 0.0102 - 1), 5 * expected);
  constexpr double kFactor = 1.8;  // 1 + 5 · 0.16: the standard deviation of 20 hits is known to 16 %
  EXPECT_LE(found.scale_std / 0.0102, kFactor * expected);
  EXPECT_GE(found.scale_std / 0.0102, expected / kFactor);
}

TEST(Calibrate, HasAStandardDeviationForOneHit) {
  const Calibration found = calibrate(free_mass({.noise = 0.01, .peaks_N = {300}}), kMass_kg);
  EXPECT_EQ(found.hits.size(), 1U);
  // The expected value is as above, for a single hit. The residuals of 15 samples give the standard deviation to 20 %.
  // The factor is 1 + 5 · 0.2 = 2, and more because 0.6 and 0.75 are rounded.
  const double expected = 0.01 * std::sqrt(2 * (1 / (15 * 0.6) + 1 / (8 * 0.75)));
  EXPECT_GE(found.scale_std / 0.0102, expected / 2.5);
  EXPECT_LE(found.scale_std / 0.0102, 2.5 * expected);
  EXPECT_LE(std::abs(found.scale / 0.0102 - 1), 5 * found.scale_std / 0.0102);
}

TEST(Calibrate, RefusesAStructureThatRings) {
  std::vector<double> force(6000), accel(6000);
  test::add_filtered_haversine(force, 300.3, 30, 300);
  for (std::size_t i = 300; i < accel.size(); ++i) {
    const double t_s = static_cast<double>(i - 300) / kFs_Hz;
    accel[i] = 40 * std::exp(-20 * t_s) * std::sin(2 * std::numbers::pi * 600 * t_s);
  }
  const Record record = record_in_memory(kFs_Hz, {force}, {{accel}});
  EXPECT_THAT(test::input_error_of([&] { calibrate(record, kMass_kg); }), testing::HasSubstr("the mass is not free"));
}

TEST(Calibrate, TakesAPulseAtTheVeryStartOrEnd) {
  for (const std::size_t at : {std::size_t{0}, std::size_t{999}}) {
    std::vector<double> force(1000), accel(1000);
    force[at] = 50;
    accel[at] = 5;
    const Calibration found = calibrate(record_in_memory(kFs_Hz, {force}, {{accel}}), 2);
    EXPECT_DOUBLE_EQ(found.scale, 0.2);
  }
}

TEST(Calibrate, NeedsExactlyOneAccelerationAndAHit) {
  using testing::HasSubstr;
  const std::vector<double> x(1000);
  const Record none = record_in_memory(kFs_Hz, {x}, {{}});
  const Record two = record_in_memory(kFs_Hz, {x}, {{x, x}});
  const Record silent = record_in_memory(kFs_Hz, {x}, {{x}});
  EXPECT_THAT(test::input_error_of([&] { calibrate(none, kMass_kg); }), HasSubstr("not 0"));
  EXPECT_THAT(test::input_error_of([&] { calibrate(two, kMass_kg); }), HasSubstr("name the one on the free mass"));
  EXPECT_THAT(test::options_of_error([&] { calibrate(two, kMass_kg); }), testing::ElementsAre("accel_channel"));
  EXPECT_THAT(test::input_error_of([&] { calibrate(silent, kMass_kg); }), HasSubstr("no hit"));
}

}  // namespace percuss::acquire::calibrate_test
