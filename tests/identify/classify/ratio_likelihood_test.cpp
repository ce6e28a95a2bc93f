#include "identify/classify/ratio_likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percuss::identify::ratio_likelihood_test {

using std::numbers::pi;

constexpr SetUpError kPlaced{.angle_rad = 0.035, .gain = 0};  // 2°

/// ∫ of a density over all χ, 0 … π.
template <class Density>
double integral(Density&& density) {
  constexpr int kSteps = 3600;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += density(RatioAngle{.chi_rad = pi * (i + 0.5) / kSteps, .std_rad = 0.01});
  return sum * pi / kSteps;
}

TEST(WrappedDensity, IsAGaussianOnTheCircleOf180Degrees) {
  constexpr double kTolerance = 1e-6;  // the lower limit that keeps every density above zero
  EXPECT_NEAR(wrapped_density(0, 0.1), 1 / (0.1 * std::sqrt(2 * pi)), kTolerance);
  EXPECT_NEAR(wrapped_density(0.1, 0.1) / wrapped_density(0, 0.1), std::exp(-0.5), kTolerance);
  EXPECT_NEAR(wrapped_density(0.03 + pi, 0.1), wrapped_density(0.03, 0.1), kTolerance);
  EXPECT_NEAR(wrapped_density(-0.03, 0.1), wrapped_density(0.03, 0.1), kTolerance);
}

TEST(WrappedDensity, IsNeverZeroAndUniformForALargeDeviation) {
  EXPECT_GT(wrapped_density(pi / 2, 1e-6), 0);
  EXPECT_DOUBLE_EQ(wrapped_density(0.3, 2), 1 / pi);
}

TEST(RatioLikelihood, ConsistsOfDensities) {
  constexpr double kTolerance = 1e-5;  // the lower limit of a density adds less than 1e-6
  for (const double second : {pi / 2, pi / 3, -pi / 2}) {
    const RatioLikelihood likelihood(0, second, kPlaced);
    EXPECT_NEAR(integral([&](const RatioAngle& r) { return likelihood.bending(r); }), 1, kTolerance);
    EXPECT_NEAR(integral([&](const RatioAngle& r) { return likelihood.bending(r, 0.3); }), 1, kTolerance);
    EXPECT_NEAR(integral([&](const RatioAngle& r) { return likelihood.hoop(r); }), 1, kTolerance);
  }
}

TEST(RatioLikelihood, PrefersHoopForOppositeMotionAt90Degrees) {
  const RatioLikelihood likelihood(0, pi / 2, kPlaced);
  const RatioAngle opposite{.chi_rad = -pi / 4, .std_rad = 0.01}, equal{.chi_rad = pi / 4, .std_rad = 0.01};
  EXPECT_GE(likelihood.hoop(opposite), 5 * likelihood.bending(opposite));
  EXPECT_LE(likelihood.hoop(equal), 0.1 * likelihood.bending(equal));
}

TEST(RatioLikelihood, IsUniformForBendingAt90Degrees) {
  // χ is the angle ψ of the bending plane, and all planes are equally likely.
  const RatioLikelihood likelihood(0, pi / 2, kPlaced);
  constexpr double kTolerance = 1e-9;  // rounding
  for (double chi = -1.5; chi < 1.6; chi += 0.25)
    EXPECT_NEAR(likelihood.bending({.chi_rad = chi, .std_rad = 0.05}) * pi, 1, kTolerance) << chi;
}

TEST(RatioLikelihood, PrefersOppositeMotionForHoopAt60Degrees) {
  // cos 2(60° − θ₀)/cos 2θ₀ takes every value: the ratio alone does not show a hoop mode …
  const RatioLikelihood likelihood(0, pi / 3, kPlaced);
  for (double chi = -1.5; chi < 1.6; chi += 0.3) {
    const RatioAngle ratio{.chi_rad = chi, .std_rad = 0.02};
    EXPECT_LE(likelihood.hoop(ratio), 10 * likelihood.bending(ratio)) << chi;
  }
  // … but one motion is more likely: opposite motion for hoop, equal motion for bending (60° is less than 90°).
  const RatioAngle opposite{.chi_rad = -pi / 4, .std_rad = 0.02}, equal{.chi_rad = pi / 4, .std_rad = 0.02};
  EXPECT_GE(likelihood.hoop(opposite), 1.5 * likelihood.bending(opposite));
  EXPECT_GE(likelihood.bending(equal), 1.5 * likelihood.hoop(equal));
}

TEST(RatioLikelihood, ExpectsModesInTheBatsPlaneOrAtRightAngles) {
  const RatioLikelihood likelihood(0, pi / 2, kPlaced);
  constexpr double kPlane = -pi / 4;  // bending at −45°, so that the ratio −1 is not unique to hoop
  const RatioAngle same{.chi_rad = -pi / 4, .std_rad = 0.01}, across{.chi_rad = pi / 4, .std_rad = 0.01},
      between{.chi_rad = 0, .std_rad = 0.01};
  EXPECT_GE(likelihood.bending(same, kPlane), 2 * likelihood.bending(same));
  EXPECT_GE(likelihood.bending(across, kPlane), 2 * likelihood.bending(across));
  EXPECT_LE(likelihood.bending(between, kPlane), 0.5 * likelihood.bending(between));
}

TEST(RatioLikelihood, DoesNotDependOnARotationOfBothSensors) {
  constexpr double kTolerance = 1e-9;  // sums of the same terms in another order
  const RatioLikelihood here(0, pi / 2, kPlaced), there(pi, 3 * pi / 2, kPlaced);
  for (double chi = -1.5; chi < 1.6; chi += 0.1) {
    const RatioAngle ratio{.chi_rad = chi, .std_rad = 0.03};
    EXPECT_NEAR(here.hoop(ratio), there.hoop(ratio), kTolerance);
    EXPECT_NEAR(here.bending(ratio), there.bending(ratio), kTolerance);
  }
}

TEST(RatioLikelihood, AllowsForAMisplacedSensor) {
  // Sensors 2° off 90° over a hoop mode turned by 40°: the ratio is −1.39, not −1.
  const double chi = std::atan(-1.39);
  const RatioAngle ratio{.chi_rad = chi, .std_rad = 0.005};
  const RatioLikelihood by_hand(0, pi / 2, kPlaced), exact(0, pi / 2, {.angle_rad = 0.001, .gain = 0});
  EXPECT_GE(by_hand.hoop(ratio), 4 * exact.hoop(ratio));
}

TEST(RatioLikelihood, IsTheDensityOfTheRatiosOverAllAngles) {
  // A histogram over angles. Without errors of gain, noise and placement, only the pattern's error of 2° remains.
  constexpr double kSecond = 1.3, kPatternStd = 0.035, kTolerance = 1e-3;  // 7200 angles, and the truncated series
  const RatioLikelihood likelihood(0.2, kSecond, {.angle_rad = 0, .gain = 0});
  constexpr int kAngles = 7200;
  for (const double chi : {-1.2, -0.5, 0.1, 0.9, 1.5}) {
    double sum = 0;
    for (int t = 0; t < kAngles; ++t) {
      const double angle = pi * t / kAngles;
      const double ratio = std::atan2(std::cos(2 * (kSecond - angle)), std::cos(2 * (0.2 - angle)));
      sum += wrapped_density(chi - ratio, kPatternStd) / kAngles;
    }
    EXPECT_NEAR(likelihood.hoop({.chi_rad = chi}), sum, kTolerance * (1 + sum)) << chi;
  }
}

TEST(RatioLikelihood, IncludesGainErrorsWhereTheyChangeTheRatio) {
  // A gain error of 10 % changes χ = −45° by 2.9°, and χ = 0 not at all.
  const RatioLikelihood known(0, pi / 2, {.angle_rad = 0.001, .gain = 0}),
      unknown(0, pi / 2, {.angle_rad = 0.001, .gain = 0.1});
  const RatioAngle off{.chi_rad = -pi / 4 + 0.12}, none{.chi_rad = 0};
  EXPECT_GE(unknown.hoop(off), 2 * known.hoop(off));
  EXPECT_NEAR(unknown.bending(none, 0), known.bending(none, 0), 1e-12);
}

}  // namespace percuss::identify::ratio_likelihood_test
