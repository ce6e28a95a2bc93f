#include "metrics/protocol/performance.hpp"

#include <gsl/gsl_const_mksa.h>
#include <gtest/gtest.h>

#include "metrics/protocol/bat_metrics.hpp"
#include "metrics/protocol/resolution.hpp"

namespace percuss::metrics::performance_test {

constexpr double kRounding = 1e-12;  // relative: a few operations in double
constexpr double kMph = kMilePerHour_mps, kOzIn2 = kOunceInch2_kgm2;

TEST(LabUnits, MatchAnIndependentSource) {
  constexpr double kPrinted = 1e-8;  // GSL prints its constants with nine digits or more
  EXPECT_NEAR(kInch_m / GSL_CONST_MKSA_INCH, 1, kPrinted);
  EXPECT_NEAR(kOunce_kg / GSL_CONST_MKSA_OUNCE_MASS, 1, kPrinted);
  EXPECT_NEAR(kPound_kg / GSL_CONST_MKSA_POUND_MASS, 1, kPrinted);
  EXPECT_NEAR(kMilePerHour_mps / GSL_CONST_MKSA_MILES_PER_HOUR, 1, kPrinted);
  EXPECT_NEAR(kOunceInch2_kgm2, GSL_CONST_MKSA_OUNCE_MASS * GSL_CONST_MKSA_INCH * GSL_CONST_MKSA_INCH,
              kPrinted * kOunceInch2_kgm2);
  EXPECT_NEAR(kMph, 0.44704, kRounding);  // exact, by 1 mi = 1609.344 m
}

TEST(Performance, BattedBallSpeedOfTheWorkedExample) {
  EXPECT_NEAR(batted_ball_speed_mps(0.728, 66 * kMph, 70 * kMph) / kMph, 97.008, 97 * kRounding);
}

TEST(Performance, ContactSpeedOfThirtyThreeInchBat) {
  constexpr double kPrinted = 0.0005;  // the figures have three decimals
  EXPECT_NEAR(contact_speed_mps(33 * kInch_m, 5 * kInch_m) / kMph, 139.143, kPrinted);
  EXPECT_NEAR(contact_speed_mps(33 * kInch_m, 6 * kInch_m) / kMph, 136, 136 * kRounding);
  EXPECT_NEAR(contact_speed_mps(33 * kInch_m, 7 * kInch_m) / kMph, 132.857, kPrinted);
}

TEST(Performance, HasTheNominalContactSpeedSixInchesFromTheTip) {
  for (const double length_in : {30.0, 31.5, 34.0})
    EXPECT_NEAR(contact_speed_mps(length_in * kInch_m, 6 * kInch_m), kNominalSpeed_mps, 61 * kRounding);
}

TEST(Performance, InertiaRatioAndBbcorOfTheWorkedExample) {
  constexpr double kPrinted = 5e-7;  // six decimals
  const double k = ball_to_bat_inertia(0.1454, 34 * kInch_m, 6 * kInch_m, 10450 * kOzIn2);
  EXPECT_NEAR(k, 0.237546, kPrinted);
  EXPECT_NEAR(bbcor_of(0.728, k), 0.519706, kPrinted);
}

TEST(Performance, InvertsBbcor) {
  for (const double besr : {0.5, 0.65, 0.728, 0.9}) {
    for (const double k : {0.05, 0.237546, 1.0}) EXPECT_NEAR(besr_from_bbcor(bbcor_of(besr, k), k), besr, kRounding);
  }
}

// A rigid bat and a ball with restitution e: angular momentum about the pivot and the definition of e give v_out/v_in.
TEST(Performance, BbcorIsTheRestitutionOfARigidPivotedBat) {
  const double ball_kg = 0.145, x_m = 0.55, moi = 0.19, in_mps = 60, e = 0.48;
  const double k = ball_kg * x_m * x_m / moi;
  // m v = −m v' + I ω/x,  ω x + v' = e v
  const double omega = ball_kg * in_mps * (1 + e) * x_m / (moi + ball_kg * x_m * x_m);
  const double out_mps = e * in_mps - omega * x_m;
  EXPECT_NEAR(bbcor_of(besr_of(out_mps, in_mps), k), e, kRounding);
}

TEST(Performance, NcaaBesrIsBesrAtTheNominalSpeed) {
  EXPECT_EQ(ncaa_besr_of(14.0, 60.0, kNominalSpeed_mps), besr_of(14.0, 60.0));
  // 5 in from the tip of a 33 in bat: δ = −22/7 mph.
  const double delta = -22.0 / 7;
  EXPECT_NEAR(ncaa_besr_of(30 * kMph, 139 * kMph, contact_speed_mps(33 * kInch_m, 5 * kInch_m)),
              (30 - delta) / (139 + delta) + 0.5, kRounding);
}

TEST(Performance, ReproducesTheBarrelSpeedOfTheSwingModel) {
  // A standard bat with v0 = 60 mph at 28 in from the knob. The source states 66 mph at the barrel, at about 31 in.
  constexpr double kPrinted_mph = 0.5;  // the source rounds to whole miles per hour
  EXPECT_NEAR(swing_speed_mps(34 * kInch_m, 6 * kInch_m, 15000 * kOzIn2) / kMph, 60, 60 * kRounding);
  EXPECT_NEAR(swing_speed_mps(34 * kInch_m, 3 * kInch_m, 15000 * kOzIn2) / kMph, 66, kPrinted_mph);
  EXPECT_NEAR(swing_speed_mps(34 * kInch_m, 6 * kInch_m, 15000 * kOzIn2, {.v0_mps = 40 * kMph}) / kMph, 40,
              40 * kRounding);
  const double light = swing_speed_mps(34 * kInch_m, 6 * kInch_m, 10000 * kOzIn2);
  EXPECT_NEAR(light / kMph, 60 * std::pow(1.5, 0.3), 60 * kRounding);
}

TEST(Performance, PendulumOfAPointMassOnAnArm) {
  // T = 2π √(a/g) for a point mass, whose moment is m a².
  const double arm_m = 0.4, mass_kg = 0.9, length_m = 0.86, cg_m = length_m - kPivot_m - arm_m;
  const double period_s = kTwoPi * std::sqrt(arm_m / kStandardGravity_mps2);
  EXPECT_NEAR(pendulum_moi_kgm2(period_s, mass_kg, length_m, cg_m, kStandardGravity_mps2), mass_kg * arm_m * arm_m,
              kRounding);
}

TEST(Performance, PendulumInTheLaboratorysUnits) {
  // MOI = t² g W a/(4π²) with 386.4 in/s², oz and in, as printed.
  const double period_s = 1.42, weight_oz = 31.05, arm_in = 34 - 6 - 12.5;
  EXPECT_NEAR(pendulum_moi_kgm2(period_s, weight_oz * kOunce_kg, 34 * kInch_m, 12.5 * kInch_m) / kOzIn2,
              period_s * period_s * 386.4 * weight_oz * arm_in / (kTwoPi * kTwoPi), 1e4 * kRounding);
}

TEST(DropClass, FollowsTheRules) {
  const auto drop = [](double weight_oz, double length_in) {
    return drop_of(weight_oz * kOunce_kg, length_in * kInch_m);
  };
  EXPECT_NEAR(drop(31, 34), -3, 34 * kRounding);
  EXPECT_EQ(drop_class_of(drop(31, 34)), -3);
  EXPECT_EQ(drop_class_of(drop(31.9, 34)), -3);
  EXPECT_EQ(drop_class_of(drop(30.9, 33)), -3);
  EXPECT_EQ(drop_class_of(drop(30.995, 34)), std::nullopt);
  EXPECT_EQ(drop_class_of(drop(31.905, 34)), std::nullopt);
}

TEST(RecordedReadings, AreRoundedByTheProtocol) {
  EXPECT_EQ(round_to_step(33.96, 0.0625), 33.9375);
  EXPECT_EQ(round_to_step(33.97, 0.0625), 34);
  EXPECT_EQ(round_to_step(31.0524, 0.005), 31.05);
  EXPECT_EQ(round_to_step(31.0526, 0.005), 31.055);
  EXPECT_EQ(round_to_step(2.6254, 0.001), 2.625);
  EXPECT_EQ(round_to_step(145.37, 0.1), 145.4);
  EXPECT_EQ(round_to_step(3.21, 0), 3.21);
  EXPECT_EQ(round_to_step(7.3, 2), 8);
}

TEST(RecordedReadings, HaveUniformErrorsWithinHalfAStep) {
  // Variance of a flat density of width w: ∫ x² dx/w over it = w²/12.
  const int parts = 100000;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double x = (i + 0.5) / parts - 0.5;
    sum += x * x / parts;
  }
  EXPECT_NEAR(reading_std(1), std::sqrt(sum), 1e-9);  // the midpoint rule's own error
}

}  // namespace percuss::metrics::performance_test
