#include "identify/shapes/shape_checks.hpp"

#include <gtest/gtest.h>

namespace percuss::identify::shape_checks_test {

constexpr double kRounding = 1e-12;

Mode mode_with(std::vector<Residue> residues) { return {.pole = {500, 0.01}, .residues = std::move(residues)}; }

TEST(DrivingPointCheck, FindsAResidueThatIsNotPositive) {
  const std::vector<Mode> modes{mode_with({{.point = 3, .channel = 0, .value = 2.0, .std = 0.1}}),
                                mode_with({{.point = 3, .channel = 0, .value = -2.0, .std = 0.1}}),
                                mode_with({{.point = 3, .channel = 0, .value = -0.2, .std = 0.1}})};
  const auto checks = check_driving_points(modes, {{.point = 3, .channel = 0}});
  ASSERT_EQ(checks.size(), 3U);
  EXPECT_FALSE(checks[0].wrong_sign);
  EXPECT_TRUE(checks[1].wrong_sign);
  EXPECT_FALSE(checks[2].wrong_sign) << "two standard deviations are no proof";
}

TEST(DrivingPointCheck, ExpectsTheSignOfTheDirections) {
  const std::vector<Mode> modes{mode_with({{.point = 3, .channel = 0, .value = -2.0, .std = 0.1}}),
                                mode_with({{.point = 3, .channel = 0, .value = 2.0, .std = 0.1}})};
  const auto checks = check_driving_points(modes, {{.point = 3, .channel = 0, .sign = -1}});
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_TRUE(checks[0].right_sign && !checks[0].wrong_sign);
  EXPECT_TRUE(!checks[1].right_sign && checks[1].wrong_sign);
}

TEST(DrivingPointCheck, SkipsUnmeasuredPoints) {
  EXPECT_TRUE(check_driving_points({mode_with({{.point = 1, .value = 1.0}})}, {{.point = 2, .channel = 0}}).empty());
}

TEST(ReciprocityCheck, ComparesBothDirections) {
  const std::vector<Mode> modes{mode_with(
      {{.point = 0, .channel = 1, .value = 1.0, .std = 0.03}, {.point = 1, .channel = 0, .value = 1.1, .std = 0.04}})};
  const auto checks = check_reciprocity(modes, {{{.point = 0, .channel = 1}, {.point = 1, .channel = 0}}});
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_NEAR(checks[0].difference, 0.1 / 1.1, kRounding);
  EXPECT_NEAR(checks[0].deviations, 0.1 / (0.05 * std::sqrt(2.0)), kRounding);
}

TEST(ReciprocityCheck, HoldsForTheResiduesOfOneShape) {
  const std::vector<double> phi{0.7, -1.3};
  std::vector<Residue> residues;
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t c = 0; c < 2; ++c)
      residues.push_back({.point = p, .channel = c, .value = phi[p] * phi[c], .std = 1e-3});
  }
  const auto checks =
      check_reciprocity({mode_with(residues)}, {{{.point = 0, .channel = 1}, {.point = 1, .channel = 0}}});
  EXPECT_LE(checks[0].deviations, kRounding);
}

// The second sensor is opposite to the blow at its point.
TEST(ReciprocityCheck, AllowsForOppositeDirections) {
  const Mode mode = mode_with(
      {{.point = 0, .channel = 1, .value = -1.0, .std = 0.01}, {.point = 1, .channel = 0, .value = 1.0, .std = 0.01}});
  const auto checks = check_reciprocity({mode}, {{{.point = 0, .channel = 1, .sign = -1}, {.point = 1, .channel = 0}}});
  EXPECT_LE(checks[0].deviations, kRounding);
}

}  // namespace percuss::identify::shape_checks_test
