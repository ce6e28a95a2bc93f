#include "identify/shapes/scan_shape.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace percuss::identify::scan_shape_test {

constexpr double kRounding = 1e-12;  // of a singular value decomposition

// Residues φ_p · channel_gain_c with equal standard deviations.
Mode mode_of(const std::vector<double>& shape, const std::vector<Complex>& channel_gain, double std) {
  Mode mode;
  for (std::size_t p = 0; p < shape.size(); ++p) {
    for (std::size_t c = 0; c < channel_gain.size(); ++c)
      mode.residues.push_back({.point = p, .channel = c, .value = shape[p] * channel_gain[c], .std = std});
  }
  return mode;
}

constexpr std::array kPoints{0, 1, 2, 3};
constexpr std::array kPositions{0.1, 0.2, 0.3, 0.4};

TEST(ShapeAlong, HasTheScaleOfTheBetterChannel) {
  const auto shape = shape_along(mode_of({2, 1, -0.5, -3}, {0.3, -0.8}, 0.01), kPoints, kPositions);
  const std::array expected{1.6, 0.8, -0.4, -2.4};  // times 0.8; positive at the first point
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(std::abs(shape.amplitude[i] - expected.at(i)), kRounding) << i;
}

TEST(ShapeAlong, CombinesTheChannelsStandardDeviations) {
  // Two equal channels: the mean of two is √2 better than one.
  const auto shape = shape_along(mode_of({1, 2, 3, -4}, {1.0, 1.0}, 0.01), kPoints, kPositions);
  for (const double std : shape.std) EXPECT_LE(std::abs(std - 0.01 / std::sqrt(2.0)), kRounding);
}

TEST(ShapeAlong, AddsTheForcesErrorToEachPoint) {
  Mode mode = mode_of({1, 2, 0, -4}, {1.0}, 0.003);
  for (Residue& r : mode.residues) r.relative_std = 0.004;
  const auto shape = shape_along(mode, kPoints, kPositions);
  EXPECT_LE(std::abs(shape.std[0] - 0.005), kRounding) << "√(0.003² + 0.004²)";
  EXPECT_LE(std::abs(shape.std[2] - 0.003), kRounding);
}

TEST(ShapeAlong, RotatesAComplexShapeToReal) {
  const Complex turned = std::polar(1.0, 2.1);
  const auto shape = shape_along(mode_of({1, 2, 0.5, -4}, {turned, 0.2 * turned}, 0.01), kPoints, kPositions);
  const std::array expected{1.0, 2.0, 0.5, -4.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(std::abs(shape.amplitude[i] - expected.at(i)), kRounding) << i;
}

TEST(ShapeAlong, OmitsPointsWithoutResidues) {
  Mode mode = mode_of({2, 1, -0.5, -3}, {1.0}, 0.01);
  mode.residues.erase(mode.residues.begin() + 1);
  const auto shape = shape_along(mode, kPoints, kPositions);
  EXPECT_EQ(shape.position_m, (std::vector{0.1, 0.3, 0.4}));
}

TEST(ShapeAlong, IsEmptyWithoutResidues) {
  const auto shape = shape_along(Mode{}, kPoints, kPositions);
  EXPECT_TRUE(shape.position_m.empty());
  EXPECT_TRUE(shape.amplitude.empty());
  EXPECT_TRUE(shape.std.empty());
}

}  // namespace percuss::identify::scan_shape_test
