#include "model/impact/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace percuss::model::impact_test {

constexpr double kRounding = 1e-12;  // relative, of the thousand steps of a contact
// The error of the steps: of a COR, of a time in seconds, and of the energy over the ball's. Measured: 5e-10 at most.
constexpr double kStepError = 1e-9;

// The default ball against a beam that practically cannot move.
Impact wall() {
  Impact impact;
  impact.beam.stiffness_Nm2 = impact.beam.mass_per_length_kgpm = 1e12;
  return impact;
}

Impact with_torsion(double torsion_Nmprad) {
  Impact impact;
  impact.beam.torsion_Nmprad = torsion_Nmprad;
  return impact;
}
Impact with_stiffness(double stiffness_Nm2) {
  Impact impact;
  impact.beam.stiffness_Nm2 = stiffness_Nm2;
  return impact;
}
Impact with_mass(double mass_per_length_kgpm) {
  Impact impact;
  impact.beam.mass_per_length_kgpm = mass_per_length_kgpm;
  return impact;
}

// Reference: ten modes of 114 cubic finite elements (scipy.linalg.eigh). scipy's DOP853 (relative 3e-13, steps of 2 µs)
// integrates the contact and locates its end as an event. Deflection and gap afterwards are evaluated at 400 001
// points. The relative error of the elements' frequencies is about 1e-5 at the tenth mode and far less at
// the lower ones: the values of the contact agree to 1e-6, those of the free motion after it to 1e-4.
struct Reference {
  double mass_per_length_kgpm, cor, contact_s, peak_force_N, forward_m, forward_s, recontact_s;
};
const std::vector<Reference> kFiniteElements{
    {2.24, 0.46994950, 0.00260235413, 846.72198, 0.02469684, 0.0176460, 0},
    {0.6, -0.06785152, 0.00218330062, 616.74566, 0.02990595, 0.0096331, 0.0167749},
    {0.8, 0.06652389, 0.00232157000, 672.20558, 0.02969802, 0.0109728, 0.0220138},
    {1.2, 0.24253546, 0.00247798711, 746.77807, 0.02835421, 0.0132134, 0}};

TEST(BeamImpact, AgreesWithFiniteElementsAndRungeKutta) {
  // About 1e-6 of the values of the contact, and 1e-4 of those after it. Measured: a third to two thirds of each.
  constexpr double kCor = 5e-7, kContact_s = 2e-9, kForce_N = 1e-3;
  constexpr double kForward_m = 2e-6, kForward_s = 1e-6, kRecontact_s = 2e-6;
  for (const Reference& reference : kFiniteElements) {
    const ImpactResult r = simulate_impact(with_mass(reference.mass_per_length_kgpm));
    EXPECT_NEAR(r.cor, reference.cor, kCor) << reference.mass_per_length_kgpm;
    EXPECT_NEAR(r.contact_s, reference.contact_s, kContact_s);
    EXPECT_NEAR(r.peak_force_N, reference.peak_force_N, kForce_N);
    EXPECT_NEAR(r.forward_deflection_m, reference.forward_m, kForward_m);
    EXPECT_NEAR(r.forward_deflection_time_s, reference.forward_s, kForward_s);
    ASSERT_EQ(r.recontact_s.has_value(), reference.recontact_s > 0);
    if (r.recontact_s) {
      EXPECT_NEAR(*r.recontact_s, reference.recontact_s, kRecontact_s);
    }
  }
}

// The rule of percuss deflect. Without damping, the backward swing may exceed the forward deflection.
TEST(BeamImpact, StatesTheLargestDeflectionByMagnitudeWithItsSign) {
  for (const double at_m : {0.1, 0.2, 0.3, 0.4, 0.51}) {
    Impact impact;
    impact.at_m = at_m;
    const ImpactResult r = simulate_impact(impact, {.series = true});
    double largest = 0;
    for (const ImpactMoment& moment : r.series) {
      if (std::abs(moment.beam_m) > std::abs(largest)) largest = moment.beam_m;
    }
    // The series has a point per 0.02 ms, so its largest value may fall short of the true one: by 1e-6 of it.
    constexpr double kSampled = 1e-5;
    EXPECT_GE(std::abs(r.peak_deflection_m), std::abs(largest) * (1 - kRounding)) << at_m;
    EXPECT_NEAR(r.peak_deflection_m, largest, kSampled * std::abs(largest)) << at_m;
    EXPECT_LE(r.forward_deflection_m, std::abs(r.peak_deflection_m));
    EXPECT_LT(r.peak_deflection_m, 0) << "the backward swing is larger at each of these places";
  }
}

TEST(BeamImpact, ConservesEnergy) {
  for (const double mass : {0.6, 1.0, 2.24, 3.0}) EXPECT_LE(simulate_impact(with_mass(mass)).energy_error, kStepError);
  Impact impact;
  impact.at_m = 0.1;
  EXPECT_LE(simulate_impact(impact).energy_error, kStepError);
  impact.beam.support = BeamSupport::free;
  EXPECT_LE(simulate_impact(impact).energy_error, kStepError);
  impact.hysteresis_spm = 0.05;
  EXPECT_LE(simulate_impact(impact).energy_error, kStepError);  // the lost energy included
}

// The factor by which halving the step reduces the error: the smallest of three halvings.
double gain(const Impact& impact, ImpactMethod method, double step_s) {
  const double truth = simulate_impact(impact, {.step_s = 1e-6}).cor;
  const auto error = [&](double s) {
    return std::abs(simulate_impact(impact, {.method = method, .step_s = s}).cor - truth);
  };
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i, step_s /= 2) least = std::min(least, error(step_s) / error(step_s / 2));
  return least;
}

TEST(BeamImpact, IsOfFourthOrder) {
  // Fourth order gives 2⁴, less the contribution of higher orders. Third order would give 8.
  for (const double mass : {1.0, 2.24}) EXPECT_GE(gain(with_mass(mass), ImpactMethod::modal, 2e-5), 12) << mass;
}

TEST(BeamImpact, ConvergesBySmallIncrementsAtFirstOrder) {
  const double gained = gain({}, ImpactMethod::small_increment, 1e-5);
  EXPECT_GE(gained, 1.9);
  EXPECT_LE(gained, 2.2);
  const double truth = simulate_impact({}).cor;
  const double classic = simulate_impact({}, {.method = ImpactMethod::small_increment}).cor;
  EXPECT_GE(std::abs(classic - truth), 1e-3);  // the documented error at 10 µs: 1e-3 to 1e-2
  EXPECT_LE(std::abs(classic - truth), 1e-2);
}

TEST(BeamImpact, MeetsItsStatedAccuracy) {
  const double truth = simulate_impact({}, {.step_s = 1e-6}).cor;
  EXPECT_NEAR(simulate_impact({}).cor, truth, kStepError);
}

TEST(BeamImpact, HardlyDependsOnTheSpringStiffness) {
  for (int i = 1; i <= 6; ++i) {
    const double cor = simulate_impact(with_torsion(500 * i)).cor;
    EXPECT_GE(cor, 0.465);
    EXPECT_LE(cor, 0.475);
  }
}

void expect_rise_and_saturation(const std::vector<double>& cor) {
  for (std::size_t i = 1; i < cor.size(); ++i) EXPECT_GT(cor[i], cor[i - 1]) << i;
  for (std::size_t i = 2; i < cor.size(); ++i) EXPECT_LT(cor[i] - cor[i - 1], cor[i - 1] - cor[i - 2]) << i;
}

TEST(BeamImpact, RisesAndSaturatesWithStiffness) {
  std::vector<double> cor;
  for (int i = 1; i <= 6; ++i) cor.push_back(simulate_impact(with_stiffness(1000 * i)).cor);
  expect_rise_and_saturation(cor);
}

TEST(BeamImpact, RisesAndSaturatesWithMass) {
  std::vector<double> cor;
  for (int i = 0; i <= 12; ++i) cor.push_back(simulate_impact(with_mass(0.6 + 0.2 * i)).cor);
  expect_rise_and_saturation(cor);
  EXPECT_LT(cor.front(), 0);  // the ball still moves in its first direction
}

TEST(BeamImpact, TouchesABeamOfSmallMassAgain) {
  for (const double mass : {0.6, 0.8}) {
    const ImpactResult r = simulate_impact(with_mass(mass));
    ASSERT_TRUE(r.recontact_s.has_value());
    EXPECT_LE(*r.recontact_s - r.contact_s, 0.03);
  }
  for (const double mass : {1.2, 2.24, 3.0}) EXPECT_FALSE(simulate_impact(with_mass(mass)).recontact_s.has_value());
}

// Reference: ten exact modes of the uniform beam on a torsion spring (roots of the determinant of its boundary
// conditions). scipy's DOP853 (relative 3e-13, steps of 2 µs) integrates each contact. After a separation the closed
// form is evaluated at 400 001 points over 80 ms to find the next contact. The values have eight decimals, the times
// whole nanoseconds.
TEST(BeamImpact, FollowsTheBallToItsLastContact) {
  struct Last {
    double mass_per_length_kgpm, final_cor;
    std::size_t contacts;
    double last_separation_s;
  };
  constexpr double kPrinted = 0.5e-8;
  for (const Last& reference : {Last{0.6, 0.97567256, 2, 0.018943089}, Last{0.7, 0.96792122, 2, 0.021599395},
                                Last{0.8, 0.91223423, 2, 0.024346503}, Last{1.0, 0.58623860, 2, 0.031413716}}) {
    const ImpactResult r = simulate_impact(with_mass(reference.mass_per_length_kgpm));
    ASSERT_TRUE(r.final_cor && r.final_cor_uncertainty) << reference.mass_per_length_kgpm;
    EXPECT_NEAR(*r.final_cor, reference.final_cor, kPrinted + kStepError) << reference.mass_per_length_kgpm;
    EXPECT_EQ(r.contacts, reference.contacts);
    EXPECT_NEAR(r.last_separation_s, reference.last_separation_s, kStepError);
    EXPECT_LE(*r.final_cor_uncertainty, kStepError);
    EXPECT_LE(r.energy_error, kStepError);
  }
}

TEST(BeamImpact, EndsWithTheFirstContactOnAHeavyBeam) {
  const ImpactResult r = simulate_impact({});
  EXPECT_EQ(r.contacts, 1U);
  EXPECT_EQ(*r.final_cor, r.cor);
  EXPECT_EQ(r.last_separation_s, r.contact_s);
}

// With loss every contact takes energy, and the ball never leaves with more than it had.
TEST(BeamImpact, LosesEnergyInEachContact) {
  Impact impact = with_mass(0.6);
  const double elastic = *simulate_impact(impact).final_cor;
  impact.hysteresis_spm = hysteresis_for_spm(0.6, impact.speed_mps);
  const ImpactResult lossy = simulate_impact(impact);
  ASSERT_TRUE(lossy.final_cor.has_value());
  EXPECT_GT(lossy.contacts, 1U);
  EXPECT_LT(*lossy.final_cor, elastic);
}

// The modes at the struck point replace the beam: the same impact.
TEST(BeamImpact, TakesTheModesOfAnyBeam) {
  Impact impact;
  const ImpactResult uniform = simulate_impact(impact);
  for (const BeamMode& mode : beam_modes(impact.beam, impact.modes)) {
    impact.struck.push_back(
        {.omega_radps = mode.omega_radps,
         .weight = mode.shape(impact.at_m) / std::sqrt(impact.beam.mass_per_length_kgpm * mode.norm_m)});
  }
  impact.beam = {};
  EXPECT_EQ(simulate_impact(impact).cor, uniform.cor);
}

TEST(BeamImpact, HasNoLargestDeflectionWhereTheBeamFliesOff) {
  for (const BeamSupport support :
       {BeamSupport::free, BeamSupport::pinned, BeamSupport::clamped, BeamSupport::torsion}) {
    Impact impact;
    impact.beam.support = support;
    const ImpactResult r = simulate_impact(impact);
    EXPECT_EQ(r.flies_off, rigid_body_modes(support) > 0);
    EXPECT_EQ(std::isnan(r.peak_deflection_m), r.flies_off);
    EXPECT_EQ(std::isnan(r.peak_deflection_time_s), r.flies_off);
  }
}

TEST(BeamImpact, MatchesHertzOnAWall) {
  const ImpactResult r = simulate_impact(wall());
  EXPECT_NEAR(r.cor, 1, kStepError);
  EXPECT_NEAR(r.contact_s / hertz_contact_s(wall()), 1, 1e-6);  // its constant has seven digits
  const double approach_m = std::pow(1.25 * 0.16 * 25 / 3.2e6, 0.4);
  EXPECT_NEAR(r.peak_force_N / (3.2e6 * std::pow(approach_m, 1.5)), 1, kStepError);
}

// The closed form that defines χ does not depend on the time steps.
TEST(BeamImpact, HasTheStatedRestitutionOnAWall) {
  for (const double restitution : {0.99, 0.9, 0.5, 0.1, 0.01}) {
    Impact impact = wall();
    impact.hysteresis_spm = hysteresis_for_spm(restitution, impact.speed_mps);
    const ImpactResult r = simulate_impact(impact);
    EXPECT_NEAR(r.cor, restitution, kStepError);
    EXPECT_LE(r.energy_error, kStepError);
    // A dent that remains after the contact keeps part of the energy, at low restitution only: 1.4 % at 0.01.
    constexpr double kDent = 0.02;
    EXPECT_NEAR(r.lost_J / (0.5 * 0.16 * 25), 1 - restitution * restitution, restitution < 0.05 ? kDent : kStepError);
  }
}

TEST(BeamImpact, LosesMoreWithALowerRestitution) {
  double before = simulate_impact({}).cor;
  for (const double restitution : {0.9, 0.7, 0.5, 0.3, 0.1}) {
    Impact impact;
    impact.hysteresis_spm = hysteresis_for_spm(restitution, impact.speed_mps);
    const double cor = simulate_impact(impact).cor;
    EXPECT_LT(cor, before);
    before = cor;
  }
}

TEST(BeamImpact, ScalesWithItsUnits) {
  // Masses and stiffnesses times 7: the same motion.
  Impact impact;
  impact.ball_mass_kg *= 7;
  impact.hertz_Npm15 *= 7;
  impact.beam.stiffness_Nm2 *= 7;
  impact.beam.mass_per_length_kgpm *= 7;
  impact.beam.torsion_Nmprad *= 7;
  EXPECT_NEAR(simulate_impact(impact).cor, simulate_impact({}).cor, kRounding);
}

TEST(BeamImpact, WritesASeriesThatMatchesItsResult) {
  const ImpactResult r = simulate_impact({}, {.series = true});
  ASSERT_GT(r.series.size(), 1000U);
  EXPECT_EQ(r.series.front().ball_speed_mps, 5);
  EXPECT_NEAR(-r.series.back().ball_speed_mps / 5, r.cor, kRounding);
  EXPECT_NEAR(r.series.back().time_s, r.contact_s + kFollowUp_s, kRounding);
  double peak_m = 0, force_N = 0, impulse_Ns = 0;
  for (std::size_t i = 0; i < r.series.size(); ++i) {
    if (std::abs(r.series[i].beam_m) > std::abs(peak_m)) peak_m = r.series[i].beam_m;
    force_N = std::max(force_N, r.series[i].force_N);
    if (i == 0) continue;
    EXPECT_GT(r.series[i].time_s, r.series[i - 1].time_s);
    impulse_Ns += (r.series[i].force_N + r.series[i - 1].force_N) / 2 * (r.series[i].time_s - r.series[i - 1].time_s);
  }
  constexpr double kSampled = 1e-4;  // relative, of peaks and trapezia between some hundred points
  EXPECT_NEAR(peak_m / r.peak_deflection_m, 1, kSampled);
  EXPECT_NEAR(force_N / r.peak_force_N, 1, kSampled);
  EXPECT_NEAR(impulse_Ns / (0.16 * 5 * (1 + r.cor)), 1, kSampled);
}

// A rigid beam that is free: a mass and an inertia, whose bounce has a closed form by momentum and energy.
TEST(BeamImpact, ConservesMomentumOnAFreeRigidBeam) {
  Impact impact;
  impact.beam.support = BeamSupport::free;
  impact.beam.stiffness_Nm2 = 1e9;
  impact.modes = 2;  // the rigid-body ones
  const double mass = 2.24 * 0.57, inertia = mass * 0.57 * 0.57 / 12, arm = impact.at_m - 0.285;
  const double effective = mass / (1 + mass * arm * arm / inertia);
  const ImpactResult r = simulate_impact(impact);
  EXPECT_NEAR(r.cor, (effective - impact.ball_mass_kg) / (effective + impact.ball_mass_kg), kStepError);
  EXPECT_FALSE(r.recontact_s.has_value());
}

TEST(BeamImpact, RefusesAContactWithoutEnd) {
  Impact impact;
  impact.hertz_Npm15 = 1e-200;
  EXPECT_THROW(simulate_impact(impact), InputError);
}

TEST(BeamImpact, RefusesValuesBeyondTheRangeOfNumbers) {
  for (const double speed_mps : {1e-300, 1e300}) {
    Impact impact;
    impact.speed_mps = speed_mps;
    EXPECT_THROW(simulate_impact(impact), InputError);
  }
}

}  // namespace percuss::model::impact_test
