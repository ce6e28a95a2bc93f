#include "identify/classify/classify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace percuss::identify::classify_test {

using std::numbers::pi;

constexpr double kRounding = 1e-12;
// With a lower confidence, classify() states the other type as an alternative.
constexpr double kSure = 0.9;

/// A mode with these residues at channels 0 and 1.
Mode mode_at(double freq_Hz, Complex first, Complex second, double std = 1e-3) {
  return {.pole = {freq_Hz, 0.005},
          .freq_std_Hz = 0.01,
          .damping_std = 1e-5,
          .residues = {{.channel = 0, .value = first, .std = std}, {.channel = 1, .value = second, .std = std}}};
}

/// Bending in the plane plane_deg, and hoop with an antinode at turn_deg. The sensors are at 0° and second_deg.
Mode bending(double freq_Hz, double plane_deg, double second_deg = 90) {
  return mode_at(freq_Hz, std::cos(plane_deg * kDegree_rad), std::cos((second_deg - plane_deg) * kDegree_rad));
}
Mode hoop(double freq_Hz, double turn_deg, double second_deg = 90) {
  return mode_at(freq_Hz, std::cos(2 * turn_deg * kDegree_rad), std::cos(2 * (second_deg - turn_deg) * kDegree_rad));
}

std::vector<ModeClassification> classifications(const std::vector<Mode>& modes, double second_deg = 90,
                                                const ClassifyOptions& options = {}) {
  const SensorPair sensors{.first = 0, .second = 1, .first_rad = 0, .second_rad = second_deg * kDegree_rad};
  return classify(modes, sensors, std::vector<std::optional<double>>(modes.size()), options);
}

TEST(Classify, RatioMinusOneIsHoop) {
  for (const double turn : {0.0, 12.0, 30.0, 40.0, 70.0, 170.0}) {
    const ModeClassification classification = classifications({hoop(1900, turn)})[0];
    EXPECT_EQ(classification.type, ModeType::hoop) << turn;
    EXPECT_GE(classification.confidence, kSure) << turn;
    EXPECT_NEAR(std::abs(*classification.ratio + 1.0), 0, kRounding) << turn;
  }
}

TEST(Classify, TangentOfAPlaneIsBending) {
  for (const double plane : {0.5, 20.0, -20.0, 70.0, 89.5, 110.0}) {
    const ModeClassification classification = classifications({bending(169, plane)})[0];
    EXPECT_EQ(classification.type, ModeType::bending) << plane;
    EXPECT_GE(classification.confidence, kSure) << plane;
    EXPECT_FALSE(classification.alternative) << plane;
    EXPECT_NEAR(classification.ratio->real() / std::tan(plane * kDegree_rad), 1, kRounding) << plane;
  }
}

TEST(Classify, EqualMotionIsBending) { EXPECT_EQ(classifications({bending(169, 45)})[0].type, ModeType::bending); }

TEST(Classify, IsUnsureOfOneBendingModeAtMinus45Degrees) {
  // Its ratio equals the hoop ratio, so that the confidence must be low.
  const ModeClassification classification = classifications({bending(169, -45)})[0];
  EXPECT_LT(classification.confidence, kSure);
  ASSERT_TRUE(classification.alternative);
  EXPECT_EQ(*classification.alternative, classification.type == ModeType::bending ? ModeType::hoop : ModeType::bending);
}

TEST(Classify, FindsBendingAt45DegreesByItsOtherPlane) {
  const auto found = classifications({bending(169, -45), bending(172, 45)});
  for (const ModeClassification& classification : found) EXPECT_EQ(classification.type, ModeType::bending);
}

TEST(Classify, IsUnsureOfHoopAtRightAnglesToThePlaneOfOtherModes) {
  // Modes at 45° show the bat's plane; a mode at right angles to it is then never certainly a hoop mode.
  const auto found = classifications({bending(169, 45), bending(575, 45), bending(1180, -45)});
  EXPECT_EQ(found[0].type, ModeType::bending);
  EXPECT_EQ(found[1].type, ModeType::bending);
  EXPECT_TRUE(found[2].type != ModeType::hoop || found[2].alternative);
}

TEST(Classify, FindsAHoopPairByItsEqualRatios) {
  const auto found = classifications({hoop(1900, 12), hoop(1912, 57)});
  for (const ModeClassification& classification : found) {
    EXPECT_EQ(classification.type, ModeType::hoop);
    EXPECT_GE(classification.confidence, kSure);
  }
}

TEST(Classify, ToleratesSensorsPlacedByHand) {
  for (const double off : {-2.0, 2.0}) {
    for (const double turn : {0.0, 20.0})
      EXPECT_EQ(classifications({hoop(1900, turn, 90 + off)})[0].type, ModeType::hoop) << off << " " << turn;
    // With both sensors near its nodes, a misplaced sensor gives a ratio that bending explains as well.
    EXPECT_NE(classifications({hoop(1900, 35, 90 + off)})[0].type, ModeType::bending) << off;
    for (const double plane : {5.0, 20.0, 65.0})
      EXPECT_EQ(classifications({bending(169, plane, 90 + off)})[0].type, ModeType::bending) << off << " " << plane;
  }
}

TEST(Classify, AcceptsASensorAtANode) {
  for (const bool first : {true, false}) {
    const ModeClassification classification =
        classifications({first ? mode_at(169, 1e-5, 1) : mode_at(169, 1, 1e-5)})[0];
    EXPECT_EQ(classification.type, ModeType::bending);
    EXPECT_TRUE(std::isfinite(classification.confidence));
    EXPECT_TRUE(std::isfinite(classification.ratio_std));
  }
}

TEST(Classify, IsUnknownWithoutTwoSensors) {
  const auto found = classify({bending(169, 20), hoop(1900, 0)}, std::nullopt, {std::nullopt, std::nullopt});
  for (const ModeClassification& classification : found) {
    EXPECT_EQ(classification.type, ModeType::unknown);
    EXPECT_EQ(classification.order, 0);
    EXPECT_FALSE(classification.ratio);
  }
}

TEST(Classify, IsUnknownForAnUnobservedOrComplexMode) {
  EXPECT_EQ(classifications({mode_at(169, 0, 0)})[0].type, ModeType::unknown);
  EXPECT_EQ(classifications({mode_at(169, 1, {0.05, 1})})[0].type, ModeType::unknown);
}

TEST(Classify, IsLessCertainForAnUncertainRatio) {
  const auto sure = classifications({mode_at(1900, 1, -1, 1e-3)})[0],
             unsure = classifications({mode_at(1900, 1, -1, 0.6)})[0];
  EXPECT_EQ(sure.type, ModeType::hoop);
  EXPECT_TRUE(unsure.type == ModeType::unknown || unsure.confidence < sure.confidence);
}

TEST(Classify, AcceptsSensorsAt60Degrees) {
  // Equal residues mean bending between the sensors; a hoop mode would have them only by chance.
  const auto found = classifications({bending(169, 30, 60), bending(575, 30, 60)}, 60);
  EXPECT_EQ(found[0].type, ModeType::bending);
  for (const double turn : {0.0, 15.0, 30.0, 60.0, 75.0}) {
    const ModeClassification classification = classifications({hoop(1900, turn, 60)}, 60)[0];
    EXPECT_FALSE(classification.type == ModeType::bending && classification.confidence > kSure) << turn;
  }
}

TEST(Classify, DoesNotDependOnUnitOrSign) {
  const auto scaled = [](Mode mode, Complex by) {
    for (Residue& r : mode.residues) {
      r.value *= by;
      r.std *= std::abs(by);
    }
    return mode;
  };
  const std::vector<Mode> modes{bending(169, 33), hoop(1900, 10), bending(2200, -50)};
  std::vector<Mode> other;
  other.reserve(modes.size());
  for (const Mode& mode : modes) other.push_back(scaled(mode, {0, -1e6}));
  const auto a = classifications(modes), b = classifications(other);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    EXPECT_EQ(a[m].type, b[m].type);
    EXPECT_NEAR(a[m].confidence, b[m].confidence, kRounding);
    EXPECT_NEAR(std::abs(*a[m].ratio - *b[m].ratio), 0, kRounding);
  }
}

TEST(Classify, DoesNotDependOnTheOrderOfSensors) {
  constexpr double kTolerance = 0.05;  // only the second sensor has the placement error
  const SensorPair ab{.first = 0, .second = 1, .first_rad = 0, .second_rad = pi / 2};
  const SensorPair ba{.first = 1, .second = 0, .first_rad = pi / 2, .second_rad = 0};
  const std::vector<std::optional<double>> overlay(2);
  const std::vector<Mode> modes{bending(169, 33), hoop(1900, 10)};
  const auto a = classify(modes, ab, overlay), b = classify(modes, ba, overlay);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_EQ(a[m].type, b[m].type);
    EXPECT_NEAR(a[m].confidence, b[m].confidence, kTolerance);
    EXPECT_NEAR(std::abs(*a[m].ratio * *b[m].ratio - 1.0), 0, kRounding);
  }
}

TEST(Classify, UsesTheRatioOverAllPoints) {
  Mode mode = mode_at(1900, 0.01, 0.02, 0.01);  // a point at a node: noise
  mode.residues.push_back({.point = 1, .channel = 0, .value = 2, .std = 0.01});
  mode.residues.push_back({.point = 1, .channel = 1, .value = -2, .std = 0.01});
  const ModeClassification classification = classifications({mode})[0];
  EXPECT_EQ(classification.type, ModeType::hoop);
  EXPECT_NEAR(classification.ratio->real(), (0.01 * 0.02 - 4) / (0.01 * 0.01 + 4), kRounding);
}

TEST(PairOfSensors, TakesTheTwoNearestToARightAngle) {
  const auto pair = pair_of_sensors({0.0, std::nullopt, 45 * kDegree_rad, -89 * kDegree_rad});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->first, 0U);
  EXPECT_EQ(pair->second, 3U);
  EXPECT_DOUBLE_EQ(pair->second_rad, -89 * kDegree_rad);
  EXPECT_TRUE(pair_of_sensors({0.0, 270 * kDegree_rad}));
}

TEST(PairOfSensors, NeedsTwoAngles) {
  EXPECT_FALSE(pair_of_sensors({}));
  EXPECT_FALSE(pair_of_sensors({0.0, std::nullopt}));
  EXPECT_FALSE(pair_of_sensors({0.0, 0.0, 360 * kDegree_rad}));  // alike for bending and hoop modes
  EXPECT_TRUE(pair_of_sensors({0.0, 180 * kDegree_rad}));
}

}  // namespace percuss::identify::classify_test
