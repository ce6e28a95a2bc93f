#include "pipeline/stages/stated_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"

// FRFs with stated standard deviations: the ± follow from the weights that the fit used and from the stated noise.
namespace percuss::pipeline::stated_noise_test {

constexpr identify::Pole kPole{.freq_Hz = 150, .damping_ratio = 0.008};
constexpr std::size_t kSeeds = 40;
// The RMS of 40 normal numbers is known to 11 %; the limits are three times as far.
constexpr double kMinRms = 0.67, kMaxRms = 1.33;

Complex accelerance(double freq_Hz) {
  const Complex s(0, kTwoPi * freq_Hz);
  const double omega = kTwoPi * kPole.freq_Hz;
  return s * s / (s * s + 2 * kPole.damping_ratio * omega * s + omega * omega);
}

// Channels with noise whose standard deviation, `relative` |H| + floor_of[c], is stated.
acquire::FrfRecord record_of(std::uint64_t seed, double relative, const std::vector<double>& floor_of) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  acquire::FrfRecord record;
  std::vector<double> freq_Hz;
  for (int k = 1; k <= 800; ++k) freq_Hz.push_back(0.5 * k);
  record.lines = acquire::lines_from_frequencies(freq_Hz, "test");
  for (std::size_t c = 0; c < floor_of.size(); ++c) {
    record.accel.push_back({.name = "accel"});
    acquire::Frf frf;
    for (const double f : freq_Hz) {
      const Complex h = accelerance(f);
      frf.std.push_back(relative * std::abs(h) + floor_of[c]);
      frf.value.push_back(h + frf.std.back() / std::sqrt(2.0) * Complex(normal(random), normal(random)));
    }
    record.frfs.push_back({.point = 0, .channel = c, .frf = std::move(frf)});
  }
  return record;
}

struct Rms {
  double freq = 0, damping = 0;
};

Rms rms_of_deviations(double relative, const std::vector<double>& floor_of) {
  Rms rms;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Analysis analysis(record_of(seed, relative, floor_of), {.band_Hz = std::pair(100.0, 200.0)});
    EXPECT_EQ(analysis.modes().size(), 1U) << seed;
    if (analysis.modes().empty()) continue;
    const identify::Mode& mode = analysis.modes().front();
    rms.freq += std::pow((mode.pole.freq_Hz - kPole.freq_Hz) / mode.freq_std_Hz, 2) / kSeeds;
    rms.damping += std::pow((mode.pole.damping_ratio - kPole.damping_ratio) / mode.damping_std, 2) / kSeeds;
  }
  return {.freq = std::sqrt(rms.freq), .damping = std::sqrt(rms.damping)};
}

void expect_true(const Rms& rms) {
  EXPECT_GT(rms.freq, kMinRms);
  EXPECT_LT(rms.freq, kMaxRms);
  EXPECT_GT(rms.damping, kMinRms);
  EXPECT_LT(rms.damping, kMaxRms);
}

TEST(StatedNoise, GivesTrueStandardDeviationsForEvenNoise) { expect_true(rms_of_deviations(0, {0.05})); }

// The lines of the resonance, which move the pole, are the noisy ones.
TEST(StatedNoise, GivesTrueStandardDeviationsForNoiseInProportionToTheFrf) {
  expect_true(rms_of_deviations(0.05, {0.002}));
}

// The fit weighs a channel by its residual, which shows the noise as well as the stated numbers do.
TEST(StatedNoise, GivesTrueStandardDeviationsForChannelsOfDifferentNoise) {
  expect_true(rms_of_deviations(0, {0.01, 0.5}));
}

}  // namespace percuss::pipeline::stated_noise_test
