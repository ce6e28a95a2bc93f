#include "identify/shapes/mac.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synth/random_stream.hpp"

namespace percuss::identify::mac_test {

using Complex = std::complex<double>;

constexpr double kRounding = 1e-14;

ShapeValues shape(std::vector<Complex> value, double std = 0) {
  const std::size_t places = value.size();
  return {.value = std::move(value), .std = std::vector<double>(places, std)};
}

// cos(n θ) at equal angles around a ring.
ShapeValues harmonic(int n, double std = 0, std::size_t places = 12) {
  std::vector<Complex> value(places);
  for (std::size_t i = 0; i < places; ++i)
    value[i] = std::cos(n * 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(places));
  return shape(std::move(value), std);
}

TEST(Mac, IsOneOfAShapeWithItselfAtAnyScaleAndPhase) {
  const ShapeValues a = shape({1, {0.5, 0.1}, -0.3, {0, 0.2}});
  ShapeValues b = a;
  for (Complex& v : b.value) v *= Complex(-3, 40);
  EXPECT_NEAR(mac(a, b).value, 1, kRounding);
  EXPECT_EQ(mac(a, b).std, 0);
}

TEST(Mac, IsZeroOfOrthogonalShapes) { EXPECT_NEAR(mac(harmonic(1), harmonic(2)).value, 0, kRounding); }

TEST(Mac, IsTheSquaredCosineBetweenRealShapes) {
  for (const double angle : {0.1, 0.7, 1.2}) {
    EXPECT_NEAR(mac(shape({1, 0}), shape({std::cos(angle), std::sin(angle)})).value, std::pow(std::cos(angle), 2),
                kRounding);
  }
}

TEST(Mac, ConjugatesTheFirstShape) {
  // Waves that travel in opposite directions are orthogonal.
  EXPECT_NEAR(mac(shape({1, {0, 1}}), shape({1, {0, -1}})).value, 0, kRounding);
  EXPECT_NEAR(mac(shape({1, {0, 1}}), shape({1, {0, 1}})).value, 1, kRounding);
}

TEST(Mac, IsSymmetric) {
  const ShapeValues a = shape({1, {0.2, 0.4}, -2}, 0.01), b = shape({{0, 1}, 0.3, 1}, 0.02);
  EXPECT_NEAR(mac(a, b).value, mac(b, a).value, kRounding);
  EXPECT_NEAR(mac(a, b).std, mac(b, a).std, kRounding);
}

TEST(Mac, IsZeroForAZeroShape) {
  EXPECT_EQ(mac(shape({0, 0}), shape({1, 2})).value, 0);
  EXPECT_EQ(mac(shape({}), shape({})).value, 0);
}

class MacDeviation : public testing::TestWithParam<double> {};

TEST_P(MacDeviation, IsTheRmsErrorFromNoise) {
  constexpr double kLow = 0.85, kHigh = 1.35;  // of 1500 trials; the first- and second-order errors are added
  constexpr double kNoise = 0.02;
  constexpr std::size_t kTrials = 1500;
  ShapeValues a = harmonic(1, kNoise), b = harmonic(1, kNoise);
  const ShapeValues other = harmonic(2);
  for (std::size_t i = 0; i < b.value.size(); ++i)
    b.value[i] = std::cos(GetParam()) * b.value[i] + std::sin(GetParam()) * other.value[i];
  const Mac truth = mac(a, b);
  double squares = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    std::vector<double> noise(4 * a.value.size());
    synth::RandomStream({7, trial}).add_normal(kNoise, noise);
    ShapeValues c = a, d = b;
    for (std::size_t i = 0; i < a.value.size(); ++i) {
      c.value[i] += Complex(noise[4 * i], noise[4 * i + 1]);
      d.value[i] += Complex(noise[4 * i + 2], noise[4 * i + 3]);
    }
    squares += std::pow(mac(c, d).value - truth.value, 2);
  }
  const double seen = std::sqrt(squares / kTrials);
  EXPECT_GE(truth.std, kLow * seen);
  EXPECT_LE(truth.std, kHigh * seen);
}

INSTANTIATE_TEST_SUITE_P(FromEqualToOrthogonal, MacDeviation,
                         testing::Values(0.0, 0.05, 0.3, 0.8, 1.3, std::numbers::pi / 2));

TEST(AutoMac, ComparesAllModesOverTheirCommonPlaces) {
  const auto with = [](std::vector<Complex> values, std::size_t first) {
    ModeShape out;
    for (std::size_t i = 0; i < values.size(); ++i)
      out.places.push_back({.point = first + i, .value = values[i], .std = 0.1});
    return out;
  };
  const auto table = auto_mac(std::vector{with({9, 1, 1}, 0), with({1, -1}, 1), with({2, 2}, 1)});
  ASSERT_EQ(table.size(), 3U);
  for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(table[m][m].value, 1);
  EXPECT_NEAR(table[0][1].value, 0, kRounding);
  EXPECT_NEAR(table[2][0].value, 1, kRounding);
  EXPECT_GT(table[2][0].std, 0);
}

}  // namespace percuss::identify::mac_test
