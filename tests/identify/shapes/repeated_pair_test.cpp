#include "identify/shapes/repeated_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/modal_frfs.hpp"

namespace percuss::identify::repeated_pair_test {

constexpr std::size_t kPoints = 8, kSensors = 2;
constexpr double kNoise = 1e-3, kDamping = 0.005, kFreq_Hz = 1000;
constexpr double kWithin = 4.5;  // standard deviations

// A ring of points around a tube; sensors at its points 0 and 2, 90° apart. The planes of the two bending modes are
// turned by 20°.
constexpr std::array<std::size_t, kSensors> kSensorPoint{0, 2};
double shape_at(std::size_t plane, std::size_t point) {
  const double angle_rad = 0.25 * std::numbers::pi * static_cast<double>(point);
  return 1.3 * std::cos(angle_rad - std::numbers::pi / 9 - 0.5 * std::numbers::pi * static_cast<double>(plane));
}

Complex residue(std::size_t plane, std::size_t point, std::size_t sensor) {
  return shape_at(plane, point) * shape_at(plane, kSensorPoint[sensor]);
}

std::vector<DrivingPoint> driving() { return {{.point = 0, .channel = 0}, {.point = 2, .channel = 1}}; }

FrfDataset set_of(double split, std::uint64_t seed, std::size_t planes = 2) {
  FrfDataset set = test::empty_set(8192, 8192, 800, 1200, kPoints * kSensors);
  set.points.assign(kPoints, set.points.front());
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    set.channels[o].point = o / kSensors;
    set.channels[o].channel = o % kSensors;
    for (std::size_t plane = 0; plane < planes; ++plane) {
      const double freq_Hz = kFreq_Hz * (1 + (plane == 0 ? 0 : split));
      test::add_mode(set, o, {freq_Hz, kDamping}, residue(plane, o / kSensors, o % kSensors));
    }
  }
  test::add_frf_noise(set, kNoise, seed);
  return set;
}

// What a search finds: one mode at the mean frequency.
Mode one_mode(double split, std::size_t planes = 2) {
  Mode mode{.pole = {kFreq_Hz * (1 + 0.5 * split), kDamping}, .freq_std_Hz = 1e-5, .damping_std = 1e-8};
  for (std::size_t o = 0; o < kPoints * kSensors; ++o) {
    Complex value;
    for (std::size_t plane = 0; plane < planes; ++plane) value += residue(plane, o / kSensors, o % kSensors);
    mode.residues.push_back({.point = o / kSensors, .channel = o % kSensors, .value = value, .std = 1e-5});
  }
  return mode;
}

double split_of(const RepeatedPair& pair) { return (pair.second.pole.freq_Hz - pair.first.pole.freq_Hz) / kFreq_Hz; }

TEST(RepeatedPair, IsNoneWhereOneShapeExplainsTheResidues) {
  const Mode mode = one_mode(0, 1);
  EXPECT_FALSE(test_rank(mode).two_modes());
  EXPECT_FALSE(repeated_pair(set_of(0, 1, 1), {mode}, 0, driving()));
}

TEST(RepeatedPair, IsNoneWithOneSensor) {
  Mode mode = one_mode(0);
  std::erase_if(mode.residues, [](const Residue& r) { return r.channel == 1; });
  EXPECT_EQ(test_rank(mode).freedom, 0);
  EXPECT_FALSE(test_rank(mode).two_modes());
}

TEST(RepeatedPair, NoiseIsOfRankOneWithinTheStatedProbability) {
  // The deviates are standard normal: χ² of noise about rank one has the stated degrees of freedom.
  constexpr int kTests = 200;
  double sum = 0, squares = 0;
  for (int i = 0; i < kTests; ++i) {
    Mode mode = one_mode(0, 1);
    FrfDataset noise = test::empty_set(8192, 8192, 999, 1001, mode.residues.size());
    test::add_frf_noise(noise, 0.05, static_cast<std::uint64_t>(i + 1));
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      mode.residues[o].value += noise.channels[o].frf.front();
      mode.residues[o].std = 0.05;
    }
    const RankTest test = test_rank(mode);
    EXPECT_FALSE(test.two_modes());
    sum += test.deviate;
    squares += test.deviate * test.deviate;
  }
  EXPECT_NEAR(sum / kTests, 0, 0.3);
  EXPECT_NEAR(std::sqrt(squares / kTests), 1, 0.2);
}

TEST(RepeatedPair, HasTheModesOfTheSensorsAtOneFrequency) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Mode mode = one_mode(0);
    const auto pair = repeated_pair(set_of(0, seed), {mode}, 0, driving());
    ASSERT_TRUE(pair) << seed;
    EXPECT_FALSE(pair->resolved);
    EXPECT_EQ(pair->first.pole, mode.pole);
    EXPECT_EQ(pair->second.pole, mode.pole);
    EXPECT_GT(pair->first.freq_std_Hz, mode.freq_std_Hz);
    for (const Mode* one : {&pair->first, &pair->second}) {
      EXPECT_FALSE(test_rank(*one).two_modes());
      // In a round tube, each plane of bending has this modal mass, for a shape that is 1 at a point in the plane.
      const ModeShape shape = shape_of(*one, {.driving = driving()});
      ASSERT_TRUE(shape.modal_mass_kg);
      EXPECT_NEAR(*shape.modal_mass_kg, 1 / (1.3 * 1.3), 1e-3);
    }
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      const Complex both = pair->first.residues[o].value + pair->second.residues[o].value;
      EXPECT_NEAR(std::abs(both - mode.residues[o].value), 0, 1e-12);
    }
  }
}

TEST(RepeatedPair, SeparatesASplitFarBelowTheBandwidth) {
  for (const double split : {1e-4, 3e-4, 1e-3}) {
    double squares = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto pair = repeated_pair(set_of(split, seed), {one_mode(split)}, 0, driving());
      ASSERT_TRUE(pair) << split;
      ASSERT_TRUE(pair->resolved) << split;
      EXPECT_NEAR(split_of(*pair) * kFreq_Hz, split * kFreq_Hz, kWithin * pair->split_std_Hz);
      squares += std::pow((split_of(*pair) - split) * kFreq_Hz / pair->split_std_Hz, 2);
      ++count;
      for (std::size_t o = 0; o < kPoints * kSensors; ++o) {
        const Residue &a = pair->first.residues[o], &b = pair->second.residues[o];
        EXPECT_NEAR(std::abs(a.value - residue(0, a.point, a.channel)), 0, kWithin * 1.5 * a.std) << split << " " << o;
        EXPECT_NEAR(std::abs(b.value - residue(1, b.point, b.channel)), 0, kWithin * 1.5 * b.std) << split << " " << o;
      }
    }
    EXPECT_LT(std::sqrt(squares / count), 1.6) << split;
    EXPECT_GT(std::sqrt(squares / count), 0.5) << split;
  }
}

TEST(RepeatedPair, IsLeftAloneBesideACloseMode) {
  Mode other = one_mode(0, 1);
  other.pole.freq_Hz += 0.2 * other.pole.half_power_Hz();
  EXPECT_FALSE(repeated_pair(set_of(0, 1), {one_mode(0), other}, 0, driving()));
}

}  // namespace percuss::identify::repeated_pair_test
