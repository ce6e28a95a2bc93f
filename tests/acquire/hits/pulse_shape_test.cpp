#include "acquire/hits/pulse_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/force_row.hpp"
#include "support/magnitude.hpp"

namespace percuss::acquire::pulse_shape_test {

using std::numbers::pi;
using test::largest_sample;

PulseShape shape_of(const std::vector<double>& x) { return shape_of_pulse(x, largest_sample(x)); }

TEST(ShapeOfPulse, InterpolatesWhereItCrossesFivePercent) {
  for (const double scale : {1.0, -1.0, 1e-30, -1e30}) {
    std::vector<double> x = {0, 0, 20, 100, 20, 0, 4};
    for (double& value : x) value *= scale;
    const PulseShape pulse = shape_of(x);
    EXPECT_EQ(pulse.peak, 3U);
    EXPECT_DOUBLE_EQ(pulse.rise, 1.25);  // 5 of the 20 between samples 1 and 2
    EXPECT_DOUBLE_EQ(pulse.fall, 4.75);
    EXPECT_TRUE(pulse.has_rise);
  }
}

TEST(ShapeOfPulse, MeasuresAHaversine) {
  std::vector<double> x(400);
  test::add_haversine(x, 50.3, 200, 7);
  const double foot = 200 / pi * std::asin(std::sqrt(0.05));
  constexpr double kChord = 0.01;  // samples: curvature/(8·slope) at 5 % of a haversine of 200 samples is 0.008
  EXPECT_LE(std::abs(shape_of(x).rise - (50.3 + foot)), kChord);
  EXPECT_LE(std::abs(shape_of(x).fall - (250.3 - foot)), kChord);
}

TEST(ShapeOfPulse, EndsWithTheSignal) {
  const PulseShape cut = shape_of({80, 100, 60});
  EXPECT_FALSE(cut.has_rise);
  EXPECT_EQ(cut.rise, 0);
  EXPECT_EQ(cut.fall, 2);
  const PulseShape lone = shape_of({3});
  EXPECT_FALSE(lone.has_rise);
  EXPECT_EQ(lone.rise, 0);
  EXPECT_EQ(lone.fall, 0);
  EXPECT_DOUBLE_EQ(shape_of({0, 0, 9}).rise, 1.05);
  EXPECT_DOUBLE_EQ(shape_of({9, 0, 0}).fall, 0.95);
}

TEST(GateAround, IsThePulseAloneInSilence) {
  std::vector<double> x(300);
  test::add_haversine(x, 100.5, 20, 50);
  const Gate gate = gate_around(x, shape_of(x), 0);
  EXPECT_LE(gate.first, 101U);
  EXPECT_GE(gate.first, 100U);  // not beyond the last zero before it
  EXPECT_GE(gate.end, 121U);
  EXPECT_LE(gate.end, 122U);
}

TEST(GateAround, HoldsAllTheRingingOfTheFilter) {
  for (const double onset : {200.0, 200.4}) {
    std::vector<double> x(500);
    test::add_filtered_haversine(x, onset, 8, 300);
    const Gate gate = gate_around(x, shape_of(x), 0);
    EXPECT_GE(onset - static_cast<double>(gate.first), 20);  // the filter rings
    for (std::size_t n = 0; n < x.size(); ++n) {
      const bool outside = n < gate.first || n >= gate.end;
      ASSERT_LE(outside ? std::abs(x[n]) : 0, 1e-9 * 300) << n;
    }
  }
}

TEST(GateAround, LeavesTheNoiseOutside) {
  std::vector<double> x(4000);
  test::add_haversine(x, 2000, 40, 100);
  const PulseShape clean = shape_of(x);
  test::add_noise(x, 0.01, 5);
  const Gate gate = gate_around(x, clean, 0.01);
  EXPECT_GE(gate.first, 2000U - 72);
  EXPECT_LE(gate.end, 2040U + 72);
  x[1500] = x[2500] = 50;  // beyond the reach of any filter: another event
  EXPECT_EQ(gate_around(x, clean, 0.01).first, gate.first);
  EXPECT_EQ(gate_around(x, clean, 0.01).end, gate.end);
}

// A gate that reached to a single sample far behind the ringing would contain all noise in between.
TEST(GateAround, EndsBeforeASampleFarBehindTheRinging) {
  std::vector<double> x(4000);
  test::add_haversine(x, 2000, 40, 100);
  const PulseShape clean = shape_of(x);
  const Gate gate = gate_around(x, clean, 0.01);
  x[1950] = x[2100] = 0.05;  // five standard deviations
  EXPECT_EQ(gate_around(x, clean, 0.01).first, gate.first);
  EXPECT_EQ(gate_around(x, clean, 0.01).end, gate.end);
  x[gate.end + 6] = 0.05;
  EXPECT_EQ(gate_around(x, clean, 0.01).end, gate.end + 7);
}

TEST(GateAround, StaysInsideTheSignal) {
  for (const std::vector<double>& x : {std::vector<double>{5}, {5, 4}, {0, 5}, {0, 0, 5}, {5, 0, 0}, {1, 5, 1}}) {
    const Gate gate = gate_around(x, shape_of(x), 0);
    EXPECT_LE(gate.first, largest_sample(x));
    EXPECT_GT(gate.end, largest_sample(x));
    EXPECT_LE(gate.end, x.size());
  }
}

TEST(Bandwidth, OfASingleSampleReachesHalfTheRate) {
  EXPECT_EQ(bandwidth_Hz(std::vector<double>{3}, 1000), 500);
  EXPECT_EQ(bandwidth_Hz(std::vector<double>{0, -1e-30, 0}, 1000), 500);
}

TEST(Bandwidth, OfAHaversineIsTheMainLobesTwentyDecibels) {
  // |F(fT)/F(0)| = |sin(π fT)/(π fT (1 − (fT)²))| = 0.1, by bisection within the main lobe
  double low = 1.1, high = 1.9;
  for (int i = 0; i < 60; ++i) {
    const double u = 0.5 * (low + high);
    (std::abs(std::sin(pi * u) / (pi * u * (1 - u * u))) > 0.1 ? low : high) = u;
  }
  for (const double scale : {1.0, -1.0, 1e-30, 1e30}) {
    std::vector<double> x(120);
    test::add_haversine(x, 10.25, 100, 250 * scale);
    const double exact = low / (100 / 25600.0);
    EXPECT_NEAR(bandwidth_Hz(x, 25600), exact, 1e-3 * exact);  // aliases of 100 samples, and linear interpolation
  }
}

TEST(Bandwidth, IsDefinedForPulsesOfAnyLength) {
  std::vector<double> x(20011, 1.0);
  EXPECT_LE(bandwidth_Hz(x, 20011), 2.0);  // the first zero of a rectangle is at 1 Hz
  EXPECT_GE(bandwidth_Hz(x, 20011), 0.9);
}

}  // namespace percuss::acquire::pulse_shape_test
