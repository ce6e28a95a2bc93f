#include "frf/spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "frf/windows.hpp"
#include "support/magnitude.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::frf::spectra_test {

TEST(LinesInBand, HoldsTheLinesFromEdgeToEdge) {
  const LineRange lines = lines_in_band(1000, 500, 10, 20);  // 2 Hz apart
  EXPECT_EQ(lines.first, 5U);
  EXPECT_EQ(lines.count, 6U);
  EXPECT_DOUBLE_EQ(lines.df_Hz(), 2);
  EXPECT_DOUBLE_EQ(lines.freq_Hz(0), 10);
  EXPECT_DOUBLE_EQ(lines.freq_Hz(5), 20);
  EXPECT_EQ(lines_in_band(1000, 500, 10.1, 19.9).first, 6U);
  EXPECT_EQ(lines_in_band(1000, 500, 10.1, 19.9).count, 4U);
}

TEST(LinesInBand, StaysWithinTheTransform) {
  EXPECT_EQ(lines_in_band(1000, 500, -50, 1e9).count, 251U);
  EXPECT_EQ(lines_in_band(1000, 501, 0, 1e9).count, 251U);
  EXPECT_EQ(lines_in_band(1000, 500, 10.5, 11.5).count, 0U);
  EXPECT_EQ(lines_in_band(1000, 500, 600, 900).count, 0U);
  EXPECT_EQ(lines_in_band(1000, 500, 20, 10).count, 0U);
}

TEST(LinesInBand, KeepsEdgesTypedAsRoundNumbers) {
  for (std::size_t samples = 100; samples < 3000; samples += 7) {  // df does not divide the edges in binary
    const LineRange lines = lines_in_band(static_cast<double>(samples) * 0.1, samples, 1.3, 4.9);
    ASSERT_EQ(lines.first, 13U) << samples;
    ASSERT_EQ(lines.count, 37U) << samples;
  }
}

acquire::Hit pulse_hit() {
  acquire::Hit hit{.first = 1000, .samples = 64, .peak = 1011, .gate_first = 1010};
  hit.gated_N = {1, 4, 2};
  return hit;
}

TEST(ForceSpectrum, IsTheTransformOfThePulseInItsPlace) {
  const LineRange lines{.fs_Hz = 1000, .samples = 64, .first = 3, .count = 20};
  const auto spectrum = force_spectrum(force_block(pulse_hit(), 1000, 0), lines);
  std::vector<Complex> exact(20);
  for (std::size_t k = 0; k < 20; ++k) {
    const double angle = kTwoPi * static_cast<double>(k + 3) / 64;
    exact[k] = std::polar(1.0, -10 * angle) + std::polar(4.0, -11 * angle) + std::polar(2.0, -12 * angle);
  }
  constexpr double kRounding = 3e-14;  // of a sum of magnitudes 7, with phases up to 30 rad
  EXPECT_LE(test::largest_difference(spectrum, exact), kRounding);
}

TEST(ForceSpectrum, CutsThePulseWithTheBlock) {
  const auto at = [](std::size_t samples) {
    return force_spectrum(force_block(pulse_hit(), 1000, 0), {.fs_Hz = 1000, .samples = samples, .count = 1})[0];
  };
  EXPECT_DOUBLE_EQ(at(12).real(), 5);
  EXPECT_DOUBLE_EQ(at(11).real(), 1);
  EXPECT_EQ(at(10), 0.0);
  EXPECT_EQ(at(4), 0.0);
}

TEST(ForceSpectrum, TakesTheWholeForceWhenItIsNotGated) {
  acquire::Hit hit = pulse_hit();
  hit.ungated_N.assign(64, 0.5);
  const LineRange lines{.fs_Hz = 1000, .samples = 64, .count = 33};
  EXPECT_EQ(force_spectrum(force_block(hit, 1000, 0), lines), real_dft(hit.ungated_N));
}

TEST(ForceBlock, CarriesTheWindowFromThePeak) {
  acquire::Hit hit = pulse_hit();
  hit.ungated_N.assign(64, 1.0);
  const ForceBlock block = force_block(hit, 1000, 50);
  EXPECT_EQ(block.offset, 10U);
  EXPECT_DOUBLE_EQ(block.force_N[0], 1 * std::exp(0.05));
  EXPECT_DOUBLE_EQ(block.force_N[1], 4);
  EXPECT_DOUBLE_EQ(block.force_N[2], 2 * std::exp(-0.05));
  EXPECT_DOUBLE_EQ(block.ungated_N[11], 1);
  EXPECT_DOUBLE_EQ(block.ungated_N[31], std::exp(-1));
  EXPECT_EQ(hit.gated_N[0], 1);  // the hit keeps its force
}

TEST(AccelSpectrum, KeepsTheMeanAndTheScale) {
  const std::vector<double> accel(80, 2.5);  // longer than the block
  const auto spectrum = accel_spectrum(pulse_hit(), accel, {.fs_Hz = 1000, .samples = 64, .count = 33}, 0);
  EXPECT_DOUBLE_EQ(spectrum[0].real(), 64 * 2.5);
  for (std::size_t k = 1; k < 33; ++k) ASSERT_LE(std::abs(spectrum[k]), 64 * 2.5 * 1e-15);  // rounding
}

synth::SyntheticTest ringing_test(std::size_t samples) {
  synth::SynthSpec spec;
  spec.samples = samples;
  spec.hits = 1;
  spec.seed = 3;
  spec.modes = {
      {.freq_Hz = 169, .damping_ratio = 0.004, .amplitude_per_sqrt_kg = 1.7},
      {.freq_Hz = 1900, .damping_ratio = 0.001, .type = synth::SynthModeType::hoop, .amplitude_per_sqrt_kg = 2.7}};
  return synth::synthesise(spec);
}

TEST(ExponentialWindow, OnBothChannelsShowsTheExactFrfAtJOmegaPlusItsDecay) {
  constexpr std::size_t kSamples = 8192;  // 0.32 s: without the window the hit still rings at the end
  const synth::SyntheticTest test = ringing_test(kSamples);
  const acquire::Hit hit = acquire::find_hits(test.record, {.gate_force = false}).at(0);
  std::vector<double> accel(hit.samples);
  test.record.read_accel_mps2(0, 0, hit.first, accel);
  const LineRange lines = lines_in_band(25600, hit.samples, 60, 3200);
  const double decay = decay_for_end(1e-11, 0.32);
  const auto force = force_spectrum(force_block(hit, 25600, decay), lines);
  const auto response = accel_spectrum(hit, accel, lines, decay);
  double error = 0, size = 0, unshifted = 0;
  for (std::size_t k = 0; k < lines.count; ++k) {
    const Complex omega(0, kTwoPi * lines.freq_Hz(k));
    const Complex exact = test::exact_at(test.truth, omega + decay, 0);
    error = std::max(error, std::abs(response[k] / force[k] - exact));
    unshifted = std::max(unshifted, std::abs(response[k] / force[k] - test::exact_at(test.truth, omega, 0)));
    size = std::max(size, std::abs(exact));
  }
  constexpr double kTail = 1e-9;  // the truncated end, 1e-11 of the start, with a margin of 100
  EXPECT_LE(error, kTail * size);
  EXPECT_GE(unshifted, 0.1 * size);  // the shift by the window's decay is large
}

TEST(Spectra, OfADelayedResponseLagInPhase) {
  constexpr std::size_t kSamples = 64, kDelay = 5;
  acquire::Hit hit = pulse_hit();
  std::vector<double> accel(kSamples);
  for (std::size_t i = 0; i < 3; ++i) accel[10 + kDelay + i] = 3 * hit.gated_N[i];
  const LineRange lines{.fs_Hz = 1000, .samples = kSamples, .count = 33};
  const auto f = force_spectrum(force_block(hit, 1000, 0), lines);
  const auto a = accel_spectrum(hit, accel, lines, 0);
  for (std::size_t k = 0; k < lines.count; ++k) {
    const Complex exact = std::polar(3.0, -kTwoPi * static_cast<double>(k * kDelay) / kSamples);
    ASSERT_LE(std::abs(a[k] / f[k] - exact), 1e-13);  // rounding; the lines of the force differ by a factor of 7
  }
}

}  // namespace percuss::frf::spectra_test
