#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/magnitude.hpp"
#include "support/record_samples.hpp"
#include "synth/pulse.hpp"
#include "synth/synthesise.hpp"

namespace percuss::synth::faulty_hits_test {

using test::accel_mps2;
using test::force_N;

SynthSpec bat() {
  SynthSpec spec;
  spec.samples = 4096;
  spec.seed = 9;
  spec.modes = {{.freq_Hz = 169, .damping_ratio = 0.010, .amplitude_per_sqrt_kg = 1.7},
                {.freq_Hz = 1900, .damping_ratio = 0.003, .type = SynthModeType::hoop, .amplitude_per_sqrt_kg = 2.7}};
  spec.points = {{.angle_rad = 0.35}};
  spec.hits = 3;
  return spec;
}

TEST(DoubleHit, AddsASecondPulseAfterTheDelay) {
  SynthSpec spec = bat();
  const SyntheticTest good = synthesise(spec);
  spec.faults = {{.hit = 1, .kind = SynthFaultKind::double_hit, .ratio = 0.35, .delay_s = 0.0121}};
  const SyntheticTest bad = synthesise(spec);
  const TrueHit& hit = bad.truth.hits[1];
  EXPECT_EQ(hit.flag, "double");
  EXPECT_DOUBLE_EQ(hit.second_peak_N, 0.35 * hit.peak_N);
  const Pulse second{spec.pulse.kind, hit.onset_s + 0.0121, hit.width_s, hit.second_peak_N};
  const PulseBasis basis = pulse_basis(second, spec.fs_Hz, {}, 0, spec.samples);
  const std::vector<double> with = force_N(bad.record, 1), without = force_N(good.record, 1);
  constexpr double kTolerance = 1e-12;  // rounding of a few hundred N
  for (std::size_t i = 0; i < basis.force_N.size(); ++i) {
    const std::size_t n = basis.first + i;
    ASSERT_LE(std::abs(with[n] - without[n] - basis.force_N[i]), kTolerance);
  }
  EXPECT_EQ(force_N(bad.record, 0), force_N(good.record, 0));  // the other hits do not change
  EXPECT_EQ(accel_mps2(bad.record, 0, 2), accel_mps2(good.record, 0, 2));
}

TEST(WeakHit, ScalesForceAndResponse) {
  SynthSpec spec = bat();
  const SyntheticTest strong = synthesise(spec);
  const std::vector<double> good = accel_mps2(strong.record, 0, 2), good_N = force_N(strong.record, 2);
  spec.faults = {{.hit = 2, .kind = SynthFaultKind::weak, .ratio = 0.03}};
  const SyntheticTest test = synthesise(spec);
  const std::vector<double> weak = accel_mps2(test.record, 0, 2), weak_N = force_N(test.record, 2);
  constexpr double kTolerance = 1e-14;  // of the largest value
  for (std::size_t i = 0; i < weak_N.size(); ++i)
    ASSERT_LE(std::abs(weak_N[i] - 0.03 * good_N[i]), kTolerance * test::largest_magnitude(good_N));
  for (std::size_t i = 0; i < weak.size(); ++i)
    ASSERT_LE(std::abs(weak[i] - 0.03 * good[i]), kTolerance * test::largest_magnitude(good));
  EXPECT_EQ(test.truth.hits[2].flag, "weak");
}

TEST(MissingHit, LeavesAnEmptyRow) {
  SynthSpec spec = bat();
  spec.faults = {{.hit = 0, .kind = SynthFaultKind::missing}};
  const SyntheticTest test = synthesise(spec);
  EXPECT_EQ(test::largest_magnitude(force_N(test.record, 0)), 0);
  EXPECT_EQ(test::largest_magnitude(accel_mps2(test.record, 0, 0)), 0);
  EXPECT_EQ(test.truth.hits[0].peak_N, 0);
}

TEST(LateTrigger, StartsTheRowAfterTheOnset) {
  SynthSpec spec = bat();
  spec.faults = {{.hit = 1, .kind = SynthFaultKind::late, .delay_s = 0.003}};
  const SyntheticTest test = synthesise(spec);
  EXPECT_DOUBLE_EQ(test.truth.hits[1].onset_s, -0.003);
  EXPECT_EQ(test::largest_magnitude(force_N(test.record, 1)), 0);
  EXPECT_GT(test::largest_magnitude(accel_mps2(test.record, 0, 1)), 10);
}

TEST(ReversedHit, ReversesOnlyTheForce) {
  SynthSpec spec = bat();
  const SyntheticTest good = synthesise(spec);
  spec.faults = {{.hit = 1, .kind = SynthFaultKind::reversed}};
  const SyntheticTest test = synthesise(spec);
  EXPECT_EQ(accel_mps2(test.record, 0, 1), accel_mps2(good.record, 0, 1));
  const std::vector<double> reversed_N = force_N(test.record, 1), good_N = force_N(good.record, 1);
  ASSERT_GT(test::largest_magnitude(good_N), 100);  // the row holds the pulse
  ASSERT_EQ(reversed_N.size(), good_N.size());
  for (std::size_t n = 0; n < good_N.size(); ++n) ASSERT_EQ(reversed_N[n], -good_N[n]) << n;
}

TEST(Recorder, ClipsAtItsLimitAndFlagsTheHit) {
  SynthSpec spec = bat();
  spec.pulse.peak_spread = 0;
  spec.faults = {{.hit = 1, .kind = SynthFaultKind::weak, .ratio = 0.5}};
  spec.recorder.force_clip_N = 200;
  const SyntheticTest test = synthesise(spec);
  EXPECT_EQ(test::largest_magnitude(force_N(test.record, 0)), 200);
  EXPECT_EQ(test.truth.hits[0].flag, "clipped");
  EXPECT_EQ(test.truth.hits[1].flag, "weak");
  EXPECT_LT(test::largest_magnitude(force_N(test.record, 1)), 200);
}

TEST(Recorder, AddsBiasAndDrift) {
  SynthSpec spec = bat();
  const SyntheticTest plain = synthesise(spec);
  spec.recorder = {.force_bias_N = 2, .accel_bias_mps2 = 0.5, .accel_drift_mps2_per_s = -3};
  const SyntheticTest test = synthesise(spec);
  EXPECT_DOUBLE_EQ(force_N(test.record, 0)[0], 2);
  constexpr double kTolerance = 1e-12;  // rounding of a few hundred m/s²
  const double t_s = 4000 / spec.fs_Hz;
  EXPECT_LE(std::abs(accel_mps2(test.record, 0, 0)[4000] - accel_mps2(plain.record, 0, 0)[4000] - (0.5 - 3 * t_s)),
            kTolerance);
}

TEST(Recorder, RoundsToItsSteps) {
  SynthSpec spec = bat();
  const SyntheticTest plain = synthesise(spec);
  spec.recorder = {.bits = 12, .force_range_N = 512.0, .accel_range_mps2 = 4096.0};
  const SyntheticTest test = synthesise(spec);
  const double step = 2 * 4096.0 / 4096;
  const std::vector<double> rounded = accel_mps2(test.record, 0, 0), exact = accel_mps2(plain.record, 0, 0);
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    ASSERT_EQ(std::remainder(rounded[i], step), 0);
    ASSERT_LE(std::abs(rounded[i] - exact[i]), step / 2);
  }
}

}  // namespace percuss::synth::faulty_hits_test
