#include "model/trampoline/trampoline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/input_error.hpp"

namespace percuss::model::trampoline_test {

// Reference figures: the same equations, solved outside percuss by scipy 1.10 (DOP853 at relative 3e-14). The
// integration variable is t^(1/4). The motions of ball and barrel are both integrated. scipy's event search finds where
// contacts end and begin again. `rebound` promises 1e-10 of the ball's speed.
constexpr double kPromised = 1e-10;

const Trampoline kBaseball = baseball_on_barrel();

std::vector<double> published_sweep() {
  std::vector<double> hoop_Hz(397);
  for (std::size_t i = 0; i < hoop_Hz.size(); ++i) hoop_Hz[i] = 100 + 25 * static_cast<double>(i);
  return hoop_Hz;
}

HoopPeak peak_of(const Trampoline& model) {
  const auto hoop_Hz = published_sweep();
  return optimal_hoop_frequency(model, hoop_Hz, hoop_sweep(model, hoop_Hz));
}

TEST(Trampoline, ReproducesTheRigidWall) {
  EXPECT_NEAR(rigid_wall_rebound(kBaseball).cor, 0.4835851208451, kPromised);
  EXPECT_NEAR(rigid_wall_rebound(kBaseball).cor, 0.48359, 0.5e-5);
  EXPECT_NEAR(rigid_wall_rebound(softball_on_barrel()).cor, 0.4328337980733, kPromised);
}

TEST(Trampoline, ReproducesIndependentFigures) {
  struct Known {
    double hoop_Hz, cor;
    std::size_t contacts;
  };
  for (const auto& [hoop_Hz, cor, contacts] : std::vector<Known>{{100, 0.1943356860663, 2},
                                                                 {150, 0.2767490568342, 2},
                                                                 {170, 0.3038963147766, 2},
                                                                 {180, 0.3164142435714, 1},
                                                                 {300, 0.4308172263908, 1},
                                                                 {400, 0.4938327524584, 1},
                                                                 {1255, 0.6771199417615, 1},
                                                                 {2300, 0.5958081528779, 1},
                                                                 {10000, 0.4891549163263, 1}}) {
    const Rebound found = rebound(kBaseball, hoop_Hz);
    EXPECT_NEAR(found.cor, cor, kPromised) << hoop_Hz;
    EXPECT_EQ(found.contacts, contacts) << hoop_Hz;
  }
}

TEST(Trampoline, RefusesABallThatDoesNotLeave) {
  Trampoline heavy = kBaseball;  // an elastic ball of 1000 kg: it bounces on the barrel, but moves inwards
  heavy.ball_mass_kg = 1000;
  heavy.damping = heavy.barrel_damping_Nspm = 0;
  EXPECT_THAT(test::input_error_of([&] { rebound(heavy, 2); }), testing::HasSubstr("after 1000 contacts"));
}

TEST(Trampoline, ReproducesTheSourcesReference) { EXPECT_NEAR(rebound(kBaseball, 10e3).cor, 0.4892, 0.5e-4); }

// The source, [8] in docs/theory/sources.md, states 1100 to 1300 Hz. The barrel's damping in its script, 90.5, gives
// 1255.2 Hz. The damping in its table, 100, gives 1275.6 Hz.
TEST(Trampoline, HasThePublishedOptimumForABaseball) {
  const HoopPeak peak = peak_of(kBaseball);
  EXPECT_GE(peak.hoop_Hz, 1100);
  EXPECT_LE(peak.hoop_Hz, 1300);
  EXPECT_NEAR(peak.hoop_Hz, 1255.2, 0.05);
  EXPECT_NEAR(peak.cor, 0.6771199460226, kPromised);
  Trampoline table = kBaseball;
  table.barrel_damping_Nspm = 100;
  EXPECT_NEAR(peak_of(table).hoop_Hz, 1275.621, 0.01);  // scipy's minimize_scalar on the reference
}

TEST(Trampoline, HasThePublishedOptimumForASoftball) {
  for (const auto& [barrel_kg, hoop_Hz] : std::vector<std::pair<double, double>>{{0.150, 953.204}, {0.160, 955.777}}) {
    Trampoline softball = softball_on_barrel();
    softball.barrel_mass_kg = barrel_kg;
    const HoopPeak peak = peak_of(softball);
    EXPECT_GE(peak.hoop_Hz, 800);
    EXPECT_LE(peak.hoop_Hz, 1000);
    EXPECT_NEAR(peak.hoop_Hz, hoop_Hz, 0.01);
  }
}

TEST(Trampoline, TouchesAgainAtLowHoopFrequencies) {
  const Rebound slow = rebound(kBaseball, 150);
  EXPECT_EQ(slow.contacts, 2U);
  EXPECT_LT(slow.first_cor, 0);  // the ball still moved inwards
  EXPECT_GT(slow.cor, 0);
  EXPECT_EQ(rebound(kBaseball, 180).contacts, 1U);
}

// The second contact disappears between 177.5 and 180 Hz. Any further contact would come from rounding errors at the
// moment when ball and barrel separate.
TEST(Trampoline, HasNoContactFromRounding) {
  for (double hoop_Hz = 150; hoop_Hz <= 200; hoop_Hz += 0.25) {
    const std::size_t contacts = rebound(kBaseball, hoop_Hz).contacts;
    EXPECT_LE(contacts, hoop_Hz < 180 ? 2U : 1U) << hoop_Hz;
    EXPECT_GE(contacts, hoop_Hz > 177.5 ? 1U : 2U) << hoop_Hz;
  }
}

TEST(Trampoline, FollowsContactsBeyondTwoMilliseconds) {
  EXPECT_GT(rebound(kBaseball, 400).contact_s, 2e-3);
  EXPECT_LT(rebound(kBaseball, 425).contact_s, 2e-3);
}

TEST(Trampoline, ConservesEnergyWithoutDampers) {
  Trampoline elastic = kBaseball;
  elastic.damping = elastic.barrel_damping_Nspm = 0;
  EXPECT_NEAR(rigid_wall_rebound(elastic).cor, 1, kPromised);
  // The barrel keeps the energy that the ball lost. The reference solver has two contacts as well.
  const Rebound found = rebound(elastic, 300);
  EXPECT_NEAR(found.cor, 0.8219291889190, kPromised);
  EXPECT_EQ(found.contacts, 2U);
}

// Without the ball's own damper the contact on a wall lasts T = 2 (δ_max/v) ∫₀¹ dx/√(1 − x^(a+2)), a closed form:
// δ_max = ((a + 2) m v²/(2 k))^(1/(a+2)), the integral √π Γ(1 + 1/n)/Γ(1/2 + 1/n) with n = a + 2.
TEST(Trampoline, HasTheClosedFormContactTimeOnAWall) {
  Trampoline elastic = kBaseball;
  elastic.damping = 0;
  const double n = elastic.stiffness_exponent + 2, v = elastic.ball_speed_mps;
  const double deepest_m = std::pow(n * elastic.ball_mass_kg * v * v / (2 * elastic.stiffness), 1 / n);
  const double integral = std::sqrt(std::numbers::pi) * std::tgamma(1 + 1 / n) / std::tgamma(0.5 + 1 / n);
  EXPECT_NEAR(rigid_wall_rebound(elastic).contact_s, 2 * deepest_m / v * integral, 1e-7 * deepest_m / v);
}

TEST(Trampoline, EndsAtEveryHoopFrequency) {
  for (double hoop_Hz = 1; hoop_Hz < 1e6; hoop_Hz *= 3.7) {
    const Rebound found = rebound(kBaseball, hoop_Hz);
    EXPECT_GE(found.cor, 0) << hoop_Hz;
    EXPECT_LE(found.cor, 1) << hoop_Hz;
  }
  EXPECT_NEAR(rebound(kBaseball, 1e6).cor, rigid_wall_rebound(kBaseball).cor, 1e-5);
}

TEST(Trampoline, DoesNotDependOnTheNumberOfThreads) {
  const auto hoop_Hz = published_sweep();
  const auto one = hoop_sweep(kBaseball, hoop_Hz, 1), many = hoop_sweep(kBaseball, hoop_Hz, 4);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].cor, many[i].cor);
}

// In the source's finite-element model, the whole ball on the barrel lowers the hoop frequency from 2300 to 1600 Hz.
TEST(Trampoline, LowersTheHoopFrequencyWithTheBallOnTheBarrel) {
  Trampoline loaded = kBaseball;
  loaded.extra_mass_kg = loaded.ball_mass_kg;
  EXPECT_NEAR(loaded_hoop_Hz(loaded, 2300), 1423, 0.5);
  EXPECT_NEAR(modal_mass_kg(0.145, 2300, 1600), 0.136, 0.5e-3);
  loaded.barrel_mass_kg = modal_mass_kg(0.145, 2300, 1600);
  EXPECT_NEAR(loaded_hoop_Hz(loaded, 2300), 1600, 1e-9);
  loaded.barrel_mass_kg = kBaseball.barrel_mass_kg;
  EXPECT_NEAR(rebound(loaded, 2300).cor, 0.6002350160640, kPromised);
}

}  // namespace percuss::model::trampoline_test
