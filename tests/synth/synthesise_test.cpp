#include "synth/synthesise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/statistics.hpp"
#include "support/record_samples.hpp"
#include "synth/pulse.hpp"

namespace percuss::synth::synthesise_test {

using std::numbers::pi;
using test::accel_mps2;
using test::force_N;

/// A bat whose slowest mode decays to e^−27 within a row.
SynthSpec bat() {
  SynthSpec spec;
  spec.samples = 65536;
  spec.seed = 5;
  spec.modes = {
      {.freq_Hz = 169, .damping_ratio = 0.010, .angle_rad = 0.4, .amplitude_per_sqrt_kg = 1.7},
      {.freq_Hz = 575, .damping_ratio = 0.006, .order = 2, .angle_rad = 0.4, .amplitude_per_sqrt_kg = 1.7},
      {.freq_Hz = 1900,
       .damping_ratio = 0.003,
       .type = SynthModeType::hoop,
       .angle_rad = 0.2,
       .amplitude_per_sqrt_kg = 2.7},
      {.freq_Hz = 7300, .damping_ratio = 0.005, .type = SynthModeType::hoop, .order = 2, .amplitude_per_sqrt_kg = 2}};
  spec.points = {{.angle_rad = 0.35}};
  spec.hits = 2;
  return spec;
}

TEST(Synthesise, HasTheExactAcceleranceAsItsRatioOfSpectra) {
  const SyntheticTest test = synthesise(bat());
  const auto lines = static_cast<std::size_t>(3500.0 / test.record.fs_Hz * 65536);
  std::vector<double> freq_Hz(lines);
  for (std::size_t k = 0; k < lines; ++k) freq_Hz[k] = static_cast<double>(k) * test.record.fs_Hz / 65536;
  // The sum of three errors: the truncation of the decay at the row's end (e^−27 = 2e-12), aliases through the filter
  // (1e-12), and rounding over a spectrum whose lines differ by a factor of 1e3.
  constexpr double kTolerance = 1e-9;
  for (std::size_t row = 0; row < 2; ++row) {
    const std::vector<Complex> f = real_dft(force_N(test.record, row));
    for (std::size_t c = 0; c < 2; ++c) {
      const std::vector<Complex> a = real_dft(accel_mps2(test.record, c, row));
      const std::vector<Complex> exact = exact_accelerance(test.truth, 0, c, freq_Hz);
      double error = 0, size = 0;
      for (std::size_t k = 50; k < lines; ++k) {
        error = std::max(error, std::abs(a[k] / f[k] - exact[k]));
        size = std::max(size, std::abs(exact[k]));
      }
      EXPECT_LE(error, kTolerance * size);
    }
  }
}

TEST(Synthesise, DoesNotDependOnThreadsButOnTheSeed) {
  SynthSpec spec = bat();
  spec.samples = 4096;
  spec.noise = {.force = 1e-3, .accel = 1e-2};
  const SyntheticTest one = synthesise(spec, 1), many = synthesise(spec, 3);
  spec.seed = 6;
  const SyntheticTest other = synthesise(spec);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(force_N(one.record, row), force_N(many.record, row));
    EXPECT_EQ(accel_mps2(one.record, 1, row), accel_mps2(many.record, 1, row));
    EXPECT_NE(accel_mps2(one.record, 1, row), accel_mps2(other.record, 1, row));
  }
  EXPECT_EQ(one.truth.bound->freq_std_Hz, many.truth.bound->freq_std_Hz);
}

TEST(Synthesise, AddsWhiteNoiseOfTheGivenLevel) {
  SynthSpec spec = bat();
  const SyntheticTest clean = synthesise(spec);
  spec.noise = {.force = 2e-3, .accel = 1e-2};
  const SyntheticTest noisy = synthesise(spec);
  const auto difference = [](std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
  };
  const std::vector<double> f = difference(force_N(noisy.record, 1), force_N(clean.record, 1));
  const std::vector<double> a = difference(accel_mps2(noisy.record, 1, 0), accel_mps2(clean.record, 1, 0));
  constexpr double kFiveDeviations = 5 * 0.00276;  // of an RMS over 65536 values: 1/√(2·65536)
  EXPECT_LE(std::abs(rms(f) / noisy.truth.force_noise_N - 1), kFiveDeviations);
  EXPECT_LE(std::abs(rms(a) / noisy.truth.accel_noise_mps2[1] - 1), kFiveDeviations);
  EXPECT_DOUBLE_EQ(noisy.truth.accel_noise_mps2[1], 0.01 * clean.truth.accel_clean_rms_mps2[1]);
  const double lag = std::inner_product(a.begin() + 1, a.end(), a.begin(), 0.0) / (rms(a) * rms(a) * 65536);
  EXPECT_LE(std::abs(lag), 5.0 / 256);  // five standard deviations of a correlation of 65536 values
}

TEST(Synthesise, RunsRepeatTheHitsWithNewNoise) {
  SynthSpec spec = bat();
  spec.samples = 2048;
  spec.runs = 3;
  const acquire::Record clean = synthesise(spec).record;
  spec.noise.accel = 1e-2;
  const acquire::Record noisy = synthesise(spec).record;
  ASSERT_EQ(clean.rows.size(), 6U);
  EXPECT_EQ(clean.rows[5].run, 2);
  EXPECT_EQ(accel_mps2(clean, 0, 1), accel_mps2(clean, 0, 5));
  EXPECT_EQ(force_N(noisy, 1), force_N(noisy, 5));
  EXPECT_NE(accel_mps2(noisy, 0, 1), accel_mps2(noisy, 0, 5));
}

TEST(Synthesise, RovingHammerNumbersItsPointsAndDrawsThem) {
  SynthSpec spec = bat();
  spec.samples = 1024;
  spec.points = {{.position_m = 0.05}, {.position_m = 0.10, .angle_rad = pi / 2}, {.position_m = 0.15}};
  const SyntheticTest test = synthesise(spec);
  ASSERT_EQ(test.record.rows.size(), 6U);
  EXPECT_EQ(test.record.rows[3].point, 1);
  ASSERT_EQ(test.record.geometry.size(), 3U);
  EXPECT_DOUBLE_EQ(test.record.geometry[1][0], 0.10);
  EXPECT_DOUBLE_EQ(test.record.geometry[1][2], spec.structure.radius_m);
  EXPECT_EQ(test.truth.residue_per_kg.size(), 3U);
}

TEST(Synthesise, ContinuousRowIsTheSumOfItsHits) {
  SynthSpec spec = bat();
  spec.layout = SynthLayout::continuous;
  spec.samples = 12800;
  spec.hits = 2;
  spec.hit_times_s = {0.05, 0.2};  // the first decay is far from over at the second hit
  const SyntheticTest both = synthesise(spec);
  ASSERT_EQ(both.record.rows.size(), 1U);
  EXPECT_TRUE(both.record.continuous);
  std::vector<double> sum(12800, 0.0);
  for (std::size_t missing = 0; missing < 2; ++missing) {
    spec.faults = {{.hit = missing, .kind = SynthFaultKind::missing}};
    const std::vector<double> one = accel_mps2(synthesise(spec).record, 0, 0);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
  }
  const std::vector<double> together = accel_mps2(both.record, 0, 0);
  constexpr double kTolerance = 1e-14;  // of the largest value: order of summation
  const double largest = *std::max_element(together.begin(), together.end());
  for (std::size_t i = 0; i < sum.size(); ++i) ASSERT_LE(std::abs(sum[i] - together[i]), kTolerance * largest) << i;
}

TEST(Synthesise, SensorsAreDescribedInTheRecord) {
  const acquire::Record record = synthesise(bat()).record;
  ASSERT_EQ(record.accel.size(), 2U);
  EXPECT_DOUBLE_EQ(*record.accel[1].angle_rad, pi / 2);
  EXPECT_DOUBLE_EQ(*record.accel[1].position_m, 0.0508);
}

TEST(Synthesise, AcceptsAFreeMassWithoutModes) {
  SynthSpec spec;
  spec.samples = 1024;
  spec.sensors = {{}};
  spec.structure.rigid_line_per_kg = {1 / 2.5};
  const SyntheticTest test = synthesise(spec);
  const std::vector<double> f = force_N(test.record, 0), a = accel_mps2(test.record, 0, 0);
  for (std::size_t i = 0; i < f.size(); ++i) ASSERT_DOUBLE_EQ(a[i], f[i] / 2.5);
}

}  // namespace percuss::synth::synthesise_test
