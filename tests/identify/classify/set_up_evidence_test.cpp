#include "identify/classify/set_up_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "identify/classify/mode_partners.hpp"

namespace percuss::identify::set_up_evidence_test {

using std::numbers::pi;

constexpr double kDecisive = 6;  // as the warnings take it
constexpr double kReversed = -1;
constexpr double kOtherTypes = 0.01;  // of other types: breathing modes have a sign, but are rare

struct Found {
  double freq_Hz = 0, ratio = 0;
};

std::vector<TypeEvidence> evidence_of(const std::vector<Found>& found, double factor) {
  std::vector<TypeEvidence> modes;
  for (const Found& one : found) {
    const double ratio = factor * one.ratio;
    modes.push_back({.freq_Hz = one.freq_Hz,
                     .ratio = RatioAngle{.chi_rad = std::atan(ratio), .std_rad = 1e-3 / (1 + ratio * ratio)},
                     .partner = {}});
  }
  find_partners(modes, {});
  return modes;
}

// The evidence for `fault` where every ratio is multiplied by `true_fault`.
double evidence_for(double fault, const std::vector<Found>& found, double true_fault = 1) {
  return log_fault_evidence(evidence_of(found, true_fault), RatioLikelihood(0, pi / 2, {}), fault);
}

// A round bat struck at this angle: all bending modes in the plane of the blow, hoop modes split or not.
std::vector<Found> round_bat(double blow_deg, bool split) {
  const double ratio = std::tan(blow_deg * kDegree_rad);
  std::vector<Found> out{{182, ratio}, {622, 1.01 * ratio}, {1265, 0.99 * ratio}, {1900, -1.01}, {2650, -0.99}};
  if (split) out = {out[0], out[1], out[2], out[3], {1912, -1.01}, out[4], {2659, -0.99}};
  return out;
}

// A wooden bat without hoop modes: each bending mode in the plane of the grain and at right angles to it.
std::vector<Found> wooden_bat(double grain_deg) {
  std::vector<Found> out;
  for (const double freq_Hz : {148.0, 560.0, 1184.0, 1925.0}) {
    const double ratio = std::tan(grain_deg * kDegree_rad);
    out.push_back({freq_Hz, ratio});
    out.push_back({1.007 * freq_Hz, -1 / ratio});
  }
  return out;
}

TEST(FaultEvidence, IsNoneForTheHoopModesOfABatStruckInLineWithASensor) {
  for (const bool split : {false, true}) {
    for (const double blow_deg : {-8.0, -0.01, 0.01, 3.0, 88.0, 90.2}) {
      const std::vector<Found> bat = round_bat(blow_deg, split);
      EXPECT_LT(evidence_for(kReversed, bat), 1) << blow_deg;
      for (const double unit : {kStandardGravity_mps2, 39.3701, 386.089, 1000.0}) {
        EXPECT_LT(evidence_for(unit, bat), 0) << blow_deg;
        EXPECT_LT(evidence_for(1 / unit, bat), 0) << blow_deg;
      }
      // Only hoop modes show the sign. Without them, both signs are equally likely.
      const std::vector<Found> bending(bat.begin(), bat.begin() + 3);
      EXPECT_NEAR(evidence_for(kReversed, bending), 0, kOtherTypes);
    }
  }
}

TEST(FaultEvidence, NamesAReversedSensorOfABatStruckObliquely) {
  for (const double blow_deg : {15.0, 30.0, 60.0, 75.0}) {
    EXPECT_GT(evidence_for(kReversed, round_bat(blow_deg, false), kReversed), kDecisive) << blow_deg;
    EXPECT_GT(evidence_for(kReversed, round_bat(blow_deg, true), kReversed), kDecisive) << blow_deg;
  }
  // Halfway between the sensors, bending has the ratio of hoop modes. Split hoop modes still show the sign: their two
  // members have the same ratio, but the planes of a bending mode are at right angles.
  EXPECT_GT(evidence_for(kReversed, round_bat(45, true), kReversed), kDecisive);
  // A bat that bends in two planes shows the sign, too.
  EXPECT_GT(evidence_for(kReversed,
                         {{172, 0.47}, {174, -2.1}, {588, 0.45}, {595, -2.2}, {1850, -1}, {1865, -1}, {2620, -0.99}},
                         kReversed),
            kDecisive);
}

TEST(FaultEvidence, TakesTheGrainOfAWoodenBatForNoUnit) {
  for (const double grain_deg : {0.2, 1.0, 5.0, 5.5, 6.0, 20.0, 45.0, 84.5, 89.5, 95.0, 174.5}) {
    const std::vector<Found> bat = wooden_bat(grain_deg);
    EXPECT_NEAR(evidence_for(kReversed, bat), 0, 1) << "both signs occur in every pair";
    for (const double unit : {kStandardGravity_mps2, 10.0, 39.3701, 386.089, 1000.0}) {
      EXPECT_LT(evidence_for(unit, bat), 1) << grain_deg << "°, " << unit;
      EXPECT_LT(evidence_for(1 / unit, bat), 1) << grain_deg << "°, " << unit;
    }
  }
}

TEST(FaultEvidence, NamesAUnitThatHoopModesOrPairsContradict) {
  for (const double unit : {kStandardGravity_mps2, 1 / kStandardGravity_mps2}) {
    EXPECT_GT(evidence_for(unit, round_bat(20, true), unit), kDecisive) << unit;
    EXPECT_GT(evidence_for(unit, wooden_bat(30), unit), kDecisive) << unit;
  }
  EXPECT_GT(evidence_for(1000, round_bat(20, true), 1000), kDecisive);
}

TEST(DividedBy, GivesTheRatioThatTheFaultMultiplied) {
  const RatioAngle angle = divided_by({.chi_rad = std::atan(-20.0), .std_rad = 1e-4}, 10);
  EXPECT_NEAR(std::tan(angle.chi_rad), -2, 1e-12);
  // d tan χ = (1 + tan² χ) dχ: 1e-4 · 401/10 of the ratio, over 1 + 2².
  EXPECT_NEAR(angle.std_rad, 1e-4 * 401 / 10 / 5, 1e-12);
  EXPECT_NEAR(divided_by({.chi_rad = 0.3, .std_rad = 1e-4}, -1).chi_rad, -0.3, 1e-12);
}

}  // namespace percuss::identify::set_up_evidence_test
