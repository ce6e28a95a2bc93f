#include "identify/decay/known_decays.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/random_stream.hpp"

namespace percuss::identify::known_decays_test {

constexpr double kFs_Hz = 8192;
constexpr std::size_t kSamples = 4096;
const std::vector<Pole> kPoles{{.freq_Hz = 200, .damping_ratio = 0.003}, {.freq_Hz = 207, .damping_ratio = 0.004}};
const std::vector<std::vector<Complex>> kAmplitude{{{3, -1}, {0.5, 2}}, {{-0.2, 0.1}, {1, 1}}};  // [channels][poles]

std::vector<DecayRate> rates() { return {decay_rate_of(kPoles[0]), decay_rate_of(kPoles[1])}; }

DecaySpectra spectra_with(double noise, std::uint64_t seed) {
  FreeDecays decays{.fs_Hz = kFs_Hz, .hits = 1, .channels = kAmplitude.size(), .response = {}};
  for (std::size_t c = 0; c < kAmplitude.size(); ++c) {
    std::vector<double> x(kSamples);
    for (std::size_t n = 0; n < kSamples; ++n) {
      for (std::size_t m = 0; m < kPoles.size(); ++m)
        x[n] += (kAmplitude[c][m] * std::exp(rates()[m].rate_radps * (static_cast<double>(n) / kFs_Hz))).real();
    }
    synth::RandomStream({seed, c}).add_normal(noise, x);
    decays.response.push_back(x);
  }
  return decay_spectra(decays);
}

TEST(KnownDecays, HaveTheAmplitudesOfTheResponses) {
  const KnownDecays fit = fit_known_decays(rates(), spectra_with(0, 1), 40, 400);
  ASSERT_EQ(fit.amplitude.rows(), 2);
  for (std::size_t c = 0; c < kAmplitude.size(); ++c) {
    for (std::size_t m = 0; m < kPoles.size(); ++m) {
      const Complex found = fit.amplitude(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(c));
      EXPECT_LE(std::abs(found - kAmplitude[c][m]), 1e-11);  // rounding of sums over 4096 samples
    }
  }
  EXPECT_NEAR(fit.explained, 1, 1e-12);
}

// The square of a deviation over its variance has the mean 1. Of 800 squares the mean scatters by 0.05; the tolerance
// is four times this.
TEST(KnownDecays, StateTheirVariances) {
  double sum = 0;
  constexpr std::uint64_t kSeeds = 100;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const KnownDecays fit = fit_known_decays(rates(), spectra_with(0.1, seed), 40, 400);
    for (Eigen::Index c = 0; c < 2; ++c) {
      for (Eigen::Index m = 0; m < 2; ++m) {
        const Complex off = fit.amplitude(m, c) - kAmplitude[static_cast<std::size_t>(c)][static_cast<std::size_t>(m)];
        sum += std::norm(off) / (2 * fit.variance(m, c));
      }
    }
  }
  EXPECT_NEAR(sum / (4 * kSeeds), 1, 0.2);
}

TEST(KnownDecays, NeedThreeLinesEach) {
  EXPECT_EQ(fit_known_decays(rates(), spectra_with(0, 1), 98, 5).amplitude.size(), 0);
  EXPECT_EQ(fit_known_decays({}, spectra_with(0, 1), 40, 400).amplitude.size(), 0);
}

}  // namespace percuss::identify::known_decays_test
