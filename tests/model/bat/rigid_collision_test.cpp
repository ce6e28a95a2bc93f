#include "model/bat/rigid_collision.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace percuss::model::rigid_test {

// The constants of the source, [10] in docs/theory/sources.md: its table before figure 2.
const RigidCollision kPublished;

TEST(RigidBat, ReproducesThePublishedSweetSpot) {
  const BestImpact best = best_impact(kPublished, 0, 0.42);
  EXPECT_NEAR(best.z_m, 0.1335, 0.5e-4);           // an independent value, to its last digit
  EXPECT_NEAR(best.exit_speed_mps, 26.7, 0.5e-1);  // the same; the source states 27 m/s at 13 cm
}

TEST(RigidBat, HasABroadSweetSpot) {
  // For this loss the source prints 11 m/s, which its own formula contradicts.
  const BestImpact best = best_impact(kPublished, 0, 0.42);
  const double loss = best.exit_speed_mps - std::min(exit_speed_mps(kPublished, best.z_m - 0.05),
                                                     exit_speed_mps(kPublished, best.z_m + 0.05));
  EXPECT_NEAR(loss, 0.73, 0.5e-2);
}

TEST(RigidBat, HasLessEffectiveMassOutwards) {
  EXPECT_EQ(effective_mass_kg(kPublished, 0), kPublished.bat_mass_kg);
  for (double z_m = 0; z_m < 0.4; z_m += 0.05)
    EXPECT_GT(effective_mass_kg(kPublished, z_m), effective_mass_kg(kPublished, z_m + 0.05));
}

constexpr double kRounding = 1e-12;  // a dozen operations on numbers of some tens

// Momentum, angular momentum and restitution, written out with the speeds of ball and bat.
TEST(RigidBat, ConservesMomentumAndAngularMomentum) {
  for (const double swing_rate : {60.0, -20.0}) {
    const RigidCollision c{.swing_rate_radps = swing_rate, .bat_speed_mps = 4};
    for (const double z_m : {-0.3, 0.0, 0.1, 0.4}) {
      const double out = exit_speed_mps(c, z_m);
      const double impulse = c.ball_mass_kg * (out + c.ball_speed_mps);
      const double bat = c.bat_speed_mps - impulse / c.bat_mass_kg;
      const double rate = c.swing_rate_radps - impulse * z_m / c.inertia_kgm2;
      EXPECT_NEAR(out - (bat + rate * z_m),
                  c.restitution * (c.ball_speed_mps + c.bat_speed_mps + c.swing_rate_radps * z_m), 100 * kRounding);
    }
  }
}

TEST(RigidBat, HasItsFastestExitAtTheBestImpact) {
  for (const double bat_speed : {-5.0, 0.0, 10.0}) {
    for (const double rate : {-20.0, 0.0, 20.0, 60.0}) {
      const RigidCollision c{.swing_rate_radps = rate, .bat_speed_mps = bat_speed};
      const BestImpact best = best_impact(c, -0.4, 0.4);
      for (double z_m = -0.4; z_m <= 0.4; z_m += 0.001)
        EXPECT_LE(exit_speed_mps(c, z_m), best.exit_speed_mps + 100 * kRounding) << bat_speed << ' ' << rate;
    }
  }
}

TEST(RigidBat, IsBestAtItsCentreOfMassWithoutRotation) {
  const BestImpact best = best_impact({.swing_rate_radps = 0}, -0.4, 0.4);
  EXPECT_NEAR(best.z_m, 0, kRounding);
}

}  // namespace percuss::model::rigid_test
