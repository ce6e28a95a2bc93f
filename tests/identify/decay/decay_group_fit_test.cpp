#include "identify/decay/decay_group_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"
#include "support/decay_bound.hpp"

namespace percuss::identify::decay_group_fit_test {

constexpr double kFs_Hz = 2048;
constexpr std::size_t kSamples = 1024, kHits = 2, kChannels = 2;

struct TrueMode {
  Pole pole;
  std::vector<Complex> amplitude;  // [hits × channels]
};

// A mode whose time constant exceeds the length of the record, and two modes two half-power bandwidths apart.
const std::vector<TrueMode>& truth() {
  static const std::vector<TrueMode> kModes{
      {{.freq_Hz = 14.5, .damping_ratio = 0.012}, {{8, 3}, {-5, 1}, {6, 2}, {-4, 0.5}}},
      {{.freq_Hz = 320, .damping_ratio = 0.01}, {{10, -4}, {2, 7}, {9, -1}, {3, 5}}},
      {{.freq_Hz = 333, .damping_ratio = 0.008}, {{3, 6}, {-8, 1}, {4, 4}, {-7, 2}}}};
  return kModes;
}

// The decays, computed in the time domain and so independent of the fit's spectra.
FreeDecays decays(double noise, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  FreeDecays out{.fs_Hz = kFs_Hz, .hits = kHits, .channels = kChannels, .response = {}};
  for (std::size_t i = 0; i < kHits * kChannels; ++i) {
    std::vector<double> y(kSamples);
    for (std::size_t n = 0; n < kSamples; ++n) {
      for (const TrueMode& mode : truth()) {
        const Complex s = decay_rate_of(mode.pole).rate_radps;
        y[n] += (mode.amplitude[i] * std::exp(s * (static_cast<double>(n) / kFs_Hz))).real();
      }
      y[n] += noise * (1 + static_cast<double>(i % kChannels)) * gauss(random);  // the second channel is noisier
    }
    out.response.push_back(std::move(y));
  }
  return out;
}

// Starts half a half-power bandwidth too high, with 1.5 times the damping.
DecayGroup start() {
  DecayGroup group{.rates = {}, .windows = {{1, kSamples / 2 - 1}}};
  for (const TrueMode& mode : truth()) {
    Pole pole = mode.pole;
    pole.freq_Hz += 0.5 * pole.half_power_Hz();
    pole.damping_ratio *= 1.5;
    group.rates.push_back(decay_rate_of(pole));
  }
  return group;
}

DecayGroupFit fit(const FreeDecays& measured) {
  const DecaySpectra spectra = decay_spectra(measured);
  const DecayGroup group = start();
  return fit_decay_group(group, spectra, spectra.lines.middleRows(1, kSamples / 2 - 1));
}

Eigen::MatrixXd bound(double noise) {
  test::NoisyDecays decays{.fs_Hz = kFs_Hz, .samples = kSamples};
  for (const TrueMode& mode : truth()) {
    decays.poles.push_back(mode.pole);
    decays.amplitude.push_back(mode.amplitude);
  }
  for (std::size_t i = 0; i < kHits * kChannels; ++i)
    decays.noise_std.push_back(noise * (1 + static_cast<double>(i % kChannels)));
  return test::decay_bound(decays);
}

TEST(DecayGroupFit, IsExactWithoutNoise) {
  std::mt19937 random(1);
  const DecayGroupFit found = fit(decays(0, random));
  constexpr double kExact = 1e-10;  // rounding, over the relative distance of the close modes
  for (std::size_t m = 0; m < truth().size(); ++m) {
    const Pole pole = found.rates[m].pole();
    EXPECT_NEAR(pole.freq_Hz, truth()[m].pole.freq_Hz, kExact * pole.freq_Hz);
    EXPECT_NEAR(pole.damping_ratio, truth()[m].pole.damping_ratio, kExact);
    for (std::size_t i = 0; i < kHits * kChannels; ++i) {
      const Complex a = found.amplitude(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(i));
      EXPECT_NEAR(std::abs(a - truth()[m].amplitude[i]), 0, 1e-8) << m << ' ' << i;
    }
  }
}

TEST(DecayGroupFit, ReachesTheCramerRaoBoundWithTrueStandardDeviations) {
  constexpr double kNoise = 0.5;
  constexpr int kSeeds = 300;
  const Eigen::MatrixXd lowest = bound(kNoise);
  const auto unknowns = lowest.rows();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(unknowns), squares = sum, stated = sum;
  int within = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed + 10));
    const DecayGroupFit found = fit(decays(kNoise, random));
    for (Eigen::Index u = 0; u < unknowns; ++u) {
      const auto m = static_cast<std::size_t>(u / 2);
      const Complex error = found.rates[m].rate_radps - decay_rate_of(truth()[m].pole).rate_radps;
      const double e = u % 2 == 0 ? error.real() : error.imag(), std = std::sqrt(found.covariance(u, u));
      sum(u) += e;
      squares(u) += e * e;
      stated(u) += std * std;
      within += std::abs(e) < 1.96 * std ? 1 : 0;
    }
  }
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    const double crb = std::sqrt(lowest(u, u));
    // 300 seeds give an RMS to 4 % and a mean to 0.06 standard deviations. The first two
    // tolerances are four times as large; the stated standard deviations vary less.
    EXPECT_NEAR(std::sqrt(squares(u) / kSeeds) / crb, 1, 0.16) << u;
    EXPECT_NEAR(sum(u) / kSeeds / crb, 0, 0.24) << u;
    EXPECT_NEAR(std::sqrt(stated(u) / kSeeds) / crb, 1, 0.05) << u;
    RecordProperty("ratio_" + std::to_string(u), std::to_string(std::sqrt(squares(u) / kSeeds) / crb));
  }
  const double covered = static_cast<double>(within) / static_cast<double>(kSeeds * unknowns);
  EXPECT_GE(covered, 0.93);  // 1800 values give the share to 0.5 %
  EXPECT_LE(covered, 0.97);
}

}  // namespace percuss::identify::decay_group_fit_test
