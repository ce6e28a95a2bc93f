#include "model/bat/bat_collision.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::model::bat_collision_test {

const BatProfile kStepped{.end_m = {0.02, 0.40, 0.50, 0.82}, .diameter_m = {0.050, 0.026, 0.040, 0.062}};

// Reference: six exact modes (as in bat_modes_test.cpp, shapes integrated over the bat by Gauss's rule) and the ball,
// as one system solved by scipy's DOP853 at relative 3e-13. Its events find the deepest compression and the end.
TEST(BatCollision, ReproducesIndependentFigures) {
  struct Known {
    double z_m, exit_mps, contact_s, largest_m, ball_share, first_share, second_share;
  };
  // Relative to 67 m/s for speeds, 0.02 m for lengths and 1 for shares. The error of the modes, 1e-6, also changes the
  // motion of the ball.
  constexpr double kAgreement = 2e-5;
  const BatModes bat = bat_modes(kStepped, {});
  for (const Known& k : std::vector<Known>{
           {0.10, -41.202497, 0.00123084661, 0.008495706616, 0.384149183, 0.21174342, 0.1548829},
           {0.50, -0.119248622, 0.00116198366, 0.016235498691, 0.569252392, 0.21316347, 0.12912372},
           {0.65, 22.178888358, 0.00102944565, 0.018798486545, 0.677189293, 3.65283916e-09, 1.39817701e-02},
           {0.78, 8.860618450, 0.00100822619, 0.018632353001, 0.610485205, 0.16201763, 0.06759268}}) {
    const BatRebound found = bat_rebound(bat, 6, {}, k.z_m);
    EXPECT_NEAR(found.exit_speed_mps, k.exit_mps, 67 * kAgreement) << k.z_m;
    EXPECT_NEAR(found.contact_s, k.contact_s, 5e-6) << k.z_m;  // located to one step
    EXPECT_NEAR(found.largest_m, k.largest_m, 0.02 * kAgreement);
    EXPECT_NEAR(found.ball_share, k.ball_share, kAgreement);
    EXPECT_NEAR(found.mode_share[0], k.first_share, kAgreement);
    EXPECT_NEAR(found.mode_share[1], k.second_share, kAgreement);
    EXPECT_EQ(found.contacts, 1U);
  }
}

// Without elastic modes e₀ of the ball is the coefficient of restitution, whatever its spring.
TEST(BatCollision, MatchesTheRigidBatWithoutModes) {
  const BatModes bat = bat_modes(kStepped, {});
  constexpr double kSteps = 1e-5;  // of the ball's 67 m/s: the error of 200 steps
  for (const double e0 : {0.3, 0.5, 0.8, 1.0}) {
    const BatCollision collision{.ball = {.restitution = e0}, .bat_speed_mps = 5};
    for (const double z_m : {0.2, 0.5, 0.7, 0.82}) {
      const double rigid = exit_speed_mps(rigid_collision(bat.inertia, collision), z_m - bat.inertia.cm_m);
      EXPECT_NEAR(bat_rebound(bat, 0, collision, z_m).exit_speed_mps, rigid, 67 * kSteps) << e0 << ' ' << z_m;
    }
  }
}

TEST(BatCollision, ConservesEnergyWithAnElasticBall) {
  const BatModes bat = bat_modes(kStepped, {});
  const BatCollision elastic{.ball = {.restitution = 1}};
  for (const double z_m : {0.3, 0.6, 0.8}) EXPECT_NEAR(bat_rebound(bat, 40, elastic, z_m).ball_share, 0, 1e-6) << z_m;
}

// The ball dissipates 1 − e₀² of the energy at its largest compression, k₁ u^(α + 1)/(α + 1).
TEST(BatCollision, DissipatesItsShareOfTheStoredEnergy) {
  const BatModes bat = bat_modes(kStepped, {});
  const BatCollision c;
  const double z_m = 0.65;
  const BatRebound found = bat_rebound(bat, 40, c, z_m);
  const double stored_J = c.ball.stiffness * std::pow(found.largest_m, c.ball.exponent + 1) / (c.ball.exponent + 1);
  const RigidCollision rigid = rigid_collision(bat.inertia, c);
  const double mass_kg = effective_mass_kg(rigid, z_m - bat.inertia.cm_m), m = c.ball.mass_kg;
  const double closing_mps = c.ball_speed_mps + swing_speed_mps(rigid, z_m - bat.inertia.cm_m);
  const double collision_J = m * mass_kg / (m + mass_kg) / 2 * closing_mps * closing_mps;
  EXPECT_NEAR(found.ball_share, 0.75 * stored_J / collision_J, 1e-5);
}

TEST(BatCollision, ConvergesWithTheSteps) {
  const BatModes bat = bat_modes(kStepped, {});
  const double exact = bat_rebound(bat, 20, {}, 0.7, {.steps = 6400}).exit_speed_mps;
  EXPECT_LE(std::abs(bat_rebound(bat, 20, {}, 0.7).exit_speed_mps - exact), 1e-5);
  EXPECT_LE(std::abs(bat_rebound(bat, 20, {}, 0.7, {.steps = 50}).exit_speed_mps - exact), 1e-3);
}

// The compliance at a point load is a sum over modes whose remainder falls like 1/N. Twice as many modes halve it.
TEST(BatCollision, ConvergesSlowlyWithTheModes) {
  const BatModes bat = bat_modes(kStepped, {}, {.modes = 160, .max_element_fraction = 1.0 / 300});
  const auto exit = [&](std::size_t modes, double z_m) { return bat_rebound(bat, modes, {}, z_m).exit_speed_mps; };
  const double end_m = bat.length_m;
  const double first = exit(40, end_m) - exit(20, end_m), second = exit(80, end_m) - exit(40, end_m),
               third = exit(160, end_m) - exit(80, end_m);
  for (const double ratio : {first / second, second / third}) {
    EXPECT_GT(ratio, 1.5);
    EXPECT_LT(ratio, 2.5);
  }
  EXPECT_GT(first, std::abs(exit(40, 0.6) - exit(20, 0.6)));  // convergence is slowest at the end of the bat
}

TEST(BatCollision, DoesNotTouchABallThatTheBatMovesAwayFrom) {
  const BatModes bat = bat_modes(kStepped, {});
  const BatRebound found = bat_rebound(bat, 10, {.ball_speed_mps = 10, .bat_speed_mps = -20}, 0.5);
  EXPECT_EQ(found.contacts, 0U);
  EXPECT_EQ(found.exit_speed_mps, -10);
}

// A ball hits a rod 10 cm from its end. A free end reflects the pulse with its own sign, a held end (here held by half
// a ton) with the opposite sign. The reference is a rod without an end near the impact.
TEST(BatWave, KeepsItsSignOnlyAtAFreeEnd) {
  constexpr double kRod_m = 2, kThick_m = 0.04, kFromEnd_m = 0.1;
  const BatProfile free{.end_m = {kRod_m}, .diameter_m = {kThick_m}};
  const BatProfile held{.end_m = {kRod_m, kRod_m + 1}, .diameter_m = {kThick_m, 1}};
  const BatProfile long_rod{.end_m = {2 * kRod_m}, .diameter_m = {kThick_m}};
  const BatCollision hit{.ball_speed_mps = 40, .swing_rate_radps = 0};
  const double z_m = kRod_m - kFromEnd_m;
  const std::vector<double> time_s{0, 1e-4, 8e-4, 9e-4};
  const auto struck = [&](const BatProfile& profile, std::size_t count) {
    const BatModes modes = bat_modes(profile, {}, {.modes = count, .max_element_fraction = 0.02 / profile.length_m()});
    const Eigen::MatrixXd wave = bat_wave(modes, count, hit, z_m, time_s);
    return Eigen::VectorXd(wave.row(static_cast<Eigen::Index>(element_at(modes.beam, z_m + 1e-9))).transpose());
  };
  // The number of modes grows with the length of the rod, so all rods include the same frequencies.
  const Eigen::VectorXd at_free = struck(free, 100), at_held = struck(held, 120), at_none = struck(long_rod, 200);
  EXPECT_EQ(at_free[0], 0);
  constexpr double kEarly = 0.03;  // reflection of the fastest part of the pulse within 0.1 ms
  EXPECT_NEAR(at_free[1], at_none[1], kEarly * at_none[1]);
  EXPECT_NEAR(at_held[1], at_none[1], kEarly * at_none[1]);
  for (const Eigen::Index i : {2, 3}) {
    EXPECT_GT(at_none[i], 0);
    EXPECT_GT(at_free[i], 1.4 * at_none[i]);
    EXPECT_LT(at_held[i], 0.25 * at_none[i]);
  }
}

// After the impact, the momentum of the bat's centre of mass is the impulse on the ball from bat_rebound.
TEST(BatWave, GivesTheCentreOfMassTheImpulseOfTheBall) {
  const BatModes bat = bat_modes(kStepped, {});
  const BatCollision c;
  const std::vector<double> time_s{4e-3, 5e-3};
  const Eigen::MatrixXd wave = bat_wave(bat, 20, c, 0.65, time_s);
  const auto at_m = positions_of(bat.beam);
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i + 1 < at_m.size(); ++i) {
    const BeamElement& e = bat.beam.elements[i];
    for (Eigen::Index t = 0; t < 2; ++t) {
      centre_m[t] += e.mass_kgpm * e.element_length_m / bat.inertia.mass_kg *
                     (wave(static_cast<Eigen::Index>(i), t) + wave(static_cast<Eigen::Index>(i) + 1, t)) / 2;
    }
  }
  const double impulse_Ns = c.ball.mass_kg * (c.ball_speed_mps + bat_rebound(bat, 20, c, 0.65).exit_speed_mps);
  EXPECT_NEAR((centre_m[1] - centre_m[0]) / 1e-3, impulse_Ns / bat.inertia.mass_kg, 0.01);
}

}  // namespace percuss::model::bat_collision_test
