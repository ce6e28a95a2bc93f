#include "synth/cramer_rao_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace percuss::synth::cramer_rao_bound_test {

using std::numbers::pi;

SynthSpec single_mode() {
  SynthSpec spec;
  spec.samples = 40960;
  spec.modes = {{.freq_Hz = 1000, .damping_ratio = 0.002, .residue_per_kg = {0.8}}};
  spec.sensors = {{}};
  spec.hits = 1;
  spec.noise.accel = 0.01;
  return spec;
}

TEST(CramerRaoBound, MatchesTheTextbookForOneLightlyDampedMode) {
  // A decay a e^−σt cos(ωt + φ) with known φ, recorded to its end with white noise s at intervals Δ. The Fisher matrix
  // of (a, σ, ω) gives
  //   var ω = 8σ³ s²Δ/a²,  var σ = 16σ³ s²Δ/a²
  const SynthSpec spec = single_mode();
  const SyntheticTest test = synthesise(spec);
  const TrueHit& hit = test.truth.hits[0];
  const double omega = 2 * pi * 1000, sigma = 0.002 * omega;
  // Haversine pulse: |F(ω)| = impulse · |sinc| / (1 − (ωT/2π)²); a = residue · ω · |F|.
  const double turns = omega * hit.width_s / (2 * pi);
  const double spectrum = 0.5 * hit.peak_N * hit.width_s * std::sin(pi * turns) / (pi * turns) / (1 - turns * turns);
  const double amplitude = 0.8 * omega * spectrum;
  const double scale = std::sqrt(8 * std::pow(sigma, 3) / spec.fs_Hz) * test.truth.accel_noise_mps2[0] / amplitude;
  constexpr double kTolerance = 0.01;  // a few times ζ: neglected terms of the damping, and of the phase
  EXPECT_LE(std::abs(test.truth.bound->freq_std_Hz[0] / (scale / (2 * pi)) - 1), kTolerance);
  EXPECT_LE(std::abs(test.truth.bound->damping_ratio_std[0] / (scale * std::sqrt(2) / omega) - 1), kTolerance);
}

TEST(CramerRaoBound, FallsWithTheRootOfTheNumberOfHits) {
  SynthSpec spec = single_mode();
  spec.pulse.peak_spread = 0;
  spec.pulse.width_spread = 0;
  spec.onset_spread_s = 0;
  const double one = synthesise(spec).truth.bound->freq_std_Hz[0];
  spec.hits = 4;
  constexpr double kTolerance = 1e-9;  // rounding of the derivatives and of the Fisher matrix
  EXPECT_LE(std::abs(synthesise(spec).truth.bound->freq_std_Hz[0] * 2 / one - 1), kTolerance);
}

TEST(CramerRaoBound, CombinesPointsLikeHits) {
  SynthSpec spec = single_mode();
  spec.pulse = {.width_spread = 0, .peak_spread = 0};
  spec.onset_spread_s = 0;
  const double one = synthesise(spec).truth.bound->freq_std_Hz[0];
  spec.points = {{}, {}};
  spec.modes[0].residue_per_kg = {0.8, 0.8};
  constexpr double kTolerance = 1e-9;  // rounding of the derivatives and of the Fisher matrix
  EXPECT_LE(std::abs(synthesise(spec).truth.bound->freq_std_Hz[0] * std::sqrt(2) / one - 1), kTolerance);
}

TEST(CramerRaoBound, IsHugeForAModeThatNoSensorMeasures) {
  SynthSpec spec = single_mode();
  spec.modes.push_back({.freq_Hz = 1500, .damping_ratio = 0.002, .residue_per_kg = {0}});
  const CramerRaoBound bound = *synthesise(spec).truth.bound;
  EXPECT_LT(bound.freq_std_Hz[0], 1);
  EXPECT_EQ(bound.freq_std_Hz[1], 1e99);
}

TEST(CramerRaoBound, IsAbsentWithoutNoise) {
  SynthSpec spec = single_mode();
  spec.noise.accel = 0;
  EXPECT_FALSE(synthesise(spec).truth.bound.has_value());
}

}  // namespace percuss::synth::cramer_rao_bound_test
