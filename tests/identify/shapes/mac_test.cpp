#include "identify/shapes/mac.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "core/math/significance.hpp"
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

TEST(Mac, HasNoDeviationBeyondItsRange) {
  EXPECT_LE(mac(harmonic(1, 5), harmonic(1, 5)).std, 1);
  const Mac middle = mac(shape({1, 0}, 3), shape({1, 1}, 3));
  EXPECT_NEAR(middle.value, 0.5, kRounding);
  EXPECT_LE(middle.std, 0.5 + kRounding);
}

// A mode's shape over 13 points whose hits scatter: relative, by a gain that all modes have in common and by one of the
// mode alone.
struct ScatteredHits {
  double common = 0, own = 0, noise = 0;
  std::size_t hits = 2;

  struct Test {
    std::vector<ModeShape> shapes;
    std::vector<ShapeInHits> in_hits;
  };
  // angle: between the shapes of the two modes. `scatter` changes the values; the places have the deviation of the
  // hits' mean, times Student's factor.
  Test test(double angle, std::uint64_t number) const {
    constexpr std::size_t kPoints = 13;
    std::vector<double> random(kPoints * hits * 7);
    synth::RandomStream({11, number}).add_normal(1, random);
    auto next = random.begin();
    Test out{.shapes = std::vector<ModeShape>(2), .in_hits = std::vector<ShapeInHits>(2)};
    for (std::size_t p = 0; p < kPoints; ++p) {
      const double x = 2 * std::numbers::pi * static_cast<double>(p) / kPoints;
      const std::array<double, 2> exact{std::cos(x), std::cos(angle) * std::cos(x) + std::sin(angle) * std::sin(x)};
      std::array<std::vector<ValueInHit>, 2> values;
      for (std::size_t h = 0; h < hits; ++h) {
        const double gain = common * *next++;
        for (std::size_t m = 0; m < 2; ++m) {
          const double own_gain = own * *next++, re = noise * *next++, im = noise * *next++;
          values[m].push_back({.hit = p * hits + h,
                               .power = 1,
                               .value = exact[m] * (1 + gain + own_gain) + Complex(re, im),
                               .std = noise});
        }
      }
      for (std::size_t m = 0; m < 2; ++m) {
        const double count = static_cast<double>(hits);
        Complex mean;
        for (const ValueInHit& one : values[m]) mean += one.value / count;
        double squares = 0;
        for (const ValueInHit& one : values[m]) squares += std::norm(one.value - mean);
        const double scatter = student_factor(count - 1) * std::sqrt(squares / (count - 1) / count);
        out.shapes[m].places.push_back({.point = p, .value = mean, .std = std::hypot(scatter, noise)});
        out.in_hits[m].push_back(values[m]);
      }
    }
    return out;
  }

  struct Rms {
    double error = 0, by_hits = 0, by_places = 0;
  };
  Rms rms(double angle) const {
    constexpr std::uint64_t kTrials = 400;
    const double truth = std::pow(std::cos(angle), 2);
    Rms out;
    for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
      const Test one = test(angle, trial);
      const Mac found = auto_mac(one.shapes, one.in_hits)[0][1];
      out.error += std::pow(found.value - truth, 2) / kTrials;
      out.by_hits += std::pow(found.std, 2) / kTrials;
      out.by_places += std::pow(auto_mac(one.shapes)[0][1].std, 2) / kTrials;
    }
    return {.error = std::sqrt(out.error), .by_hits = std::sqrt(out.by_hits), .by_places = std::sqrt(out.by_places)};
  }
};

class MacOfScatteredHits : public testing::TestWithParam<std::tuple<std::size_t, double>> {};

// Two hits hardly determine the scatter of one point; all points together determine that of the MAC. The scatter that
// the modes have in common changes a MAC less than scatter of each mode alone.
TEST_P(MacOfScatteredHits, IsTheRmsErrorFromFewHitsPerPoint) {
  const auto [hits, angle] = GetParam();
  for (const double common : {0.0, 0.1}) {
    const auto rms = ScatteredHits{.common = common, .own = 0.03, .noise = 1e-3, .hits = hits}.rms(angle);
    EXPECT_GE(rms.by_hits, 0.75 * rms.error) << common;
    // At MAC 0 and 1 the measured shapes are off the extreme, so that the first order adds to the second.
    EXPECT_LE(rms.by_hits, (angle == 0 || angle == std::numbers::pi / 2 ? 1.9 : 1.5) * rms.error) << common;
    if (hits == 2) {
      EXPECT_GE(rms.by_places, 4 * rms.error) << common;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FromEqualToOrthogonal, MacOfScatteredHits,
                         testing::Combine(testing::Values(2U, 3U, 5U),
                                          testing::Values(0.0, 0.3, 0.8, 1.3, std::numbers::pi / 2)));

TEST(AutoMac, KeepsTheDeviationOfTheNoiseWhereHitsDoNotScatter) {
  const auto one = ScatteredHits{.common = 0, .own = 0, .noise = 1e-3, .hits = 2}.test(0.8, 1);
  EXPECT_EQ(auto_mac(one.shapes, one.in_hits)[0][1].std, auto_mac(one.shapes)[0][1].std);
}

}  // namespace percuss::identify::mac_test
