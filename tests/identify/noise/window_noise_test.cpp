#include "identify/noise/window_noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::window_noise_test {

constexpr std::size_t kSamples = 8192;
constexpr double kFs_Hz = 8192;    // a record of one second
constexpr double kSampled = 2e-3;  // sums over samples instead of integrals

FrfDataset windowed(double decay_per_s) {
  FrfDataset set = test::empty_set(kFs_Hz, kSamples, 40, 2400, 1);
  set.points[0].blocks[0].decay_per_s = decay_per_s;
  return set;
}

/// Σ w^power exp(−2σt) t^growth exp(−2πjmt) over the samples, with the window w = exp(−decay_per_s t),
/// σ = mode_decay_per_s and m = apart.
std::complex<double> sum(double decay_per_s, int power, double mode_decay_per_s, int growth, int apart) {
  std::complex<double> total;
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double t_s = static_cast<double>(n) / kFs_Hz;
    total += std::pow(t_s, growth) *
             std::polar(std::exp(-(power * decay_per_s + 2 * mode_decay_per_s) * t_s), -kTwoPi * apart * t_s);
  }
  return total;
}

TEST(WindowNoise, HasTheRoughnessOfCorrelatedLines) {
  for (const double decay_per_s : {0.3, 4.6, 20.0}) {
    const auto correlation = [&](int apart) {
      return (sum(decay_per_s, 2, 0, 0, apart) / sum(decay_per_s, 2, 0, 0, 0)).real();
    };
    EXPECT_NEAR(WindowNoise(windowed(decay_per_s)).roughness(), 1.5 - 2 * correlation(1) + 0.5 * correlation(2),
                kSampled);
  }
}

TEST(WindowNoise, HasTheFactorsOfWeightedLeastSquaresOverTime) {
  const Pole pole{.freq_Hz = 500, .damping_ratio = 0.004};  // decays within the record
  const double mode_decay_per_s = pole.damping_ratio * kTwoPi * pole.freq_Hz;
  for (const double decay_per_s : {2.0, 4.6, 20.0}) {
    const WindowNoise noise(windowed(decay_per_s));
    const double mean = sum(decay_per_s, 2, 0, 0, 0).real() / kSamples;
    // The fit of a residue (growth 0) and a pole (growth 1) with equal weights, and the covariance of its results.
    const auto moments = [&](int power) {
      Eigen::Matrix2d matrix;
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) matrix(i, j) = sum(decay_per_s, power, mode_decay_per_s, i + j, 0).real();
      }
      return matrix;
    };
    const Eigen::Matrix2d normal = moments(2), noisy = moments(4), inverse = normal.inverse();
    const Eigen::Matrix2d covariance = inverse * noisy * inverse / mean;
    const double known = 1 / normal(0, 0), known_windowed = noisy(0, 0) * known * known / mean;
    const auto expect_factor = [&](double found, double exact) {
      EXPECT_NEAR(found / std::max(1.0, exact), 1, 10 * kSampled) << decay_per_s;
    };
    expect_factor(noise.of_residue(pole), known_windowed / known);
    expect_factor(noise.of_pole(pole), covariance(1, 1) / inverse(1, 1));
    expect_factor(noise.of_residue_by_pole(pole), (covariance(0, 0) - known_windowed) / (inverse(0, 0) - known));
    EXPECT_GE(noise.max_factor(), noise.of_residue_by_pole(pole));
  }
}

TEST(WindowNoise, IsWhiteWithoutAWindow) {
  const WindowNoise noise(windowed(0));
  const Pole pole{.freq_Hz = 500, .damping_ratio = 0.004};
  EXPECT_EQ(noise.roughness(), 1.5);
  EXPECT_EQ(noise.max_factor(), 1);
  EXPECT_EQ(noise.of_pole(pole), 1);
  EXPECT_EQ(noise.of_residue(pole), 1);
  EXPECT_EQ(noise.of_residue_by_pole(pole), 1);
}

// If the fit took the lines as independent, two of three records would give spurious modes, and the standard deviations
// would be half of the true ones.
TEST(WindowNoise, LetsFitsFindTheModesAndTheirStandardDeviations) {
  constexpr std::size_t kRecords = 12;
  // A standard deviation from 72 values is accurate to 8 %. The limits are four times this, and the error of the model.
  constexpr double kMin = 0.65, kMax = 1.4;
  const std::vector<double> freq_Hz{165, 568, 1177}, damping_ratio{0.01, 0.007, 0.006};
  double squares = 0;
  for (std::size_t seed = 0; seed < kRecords; ++seed) {
    synth::SynthSpec spec =
        test::bat_spec({{.freq_Hz = 165, .damping_ratio = 0.01, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                        {.freq_Hz = 568, .damping_ratio = 0.007, .order = 2, .amplitude_per_sqrt_kg = 1.9},
                        {.freq_Hz = 1177, .damping_ratio = 0.006, .order = 3, .amplitude_per_sqrt_kg = 2}},
                       1);
    spec.seed = seed;
    spec.hits = 3;
    spec.noise = {.force = 1e-5, .accel = 1e-2};
    const pipeline::Analysis analysis(synth::synthesise(spec).record,
                                      {.band_Hz = std::pair{60.0, 2000.0}, .exponential_end = 0.01});
    const auto& modes = analysis.modes();
    ASSERT_EQ(modes.size(), freq_Hz.size()) << seed;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      squares += std::pow((modes[m].pole.freq_Hz - freq_Hz[m]) / modes[m].freq_std_Hz, 2);
      squares += std::pow((modes[m].pole.damping_ratio - damping_ratio[m]) / modes[m].damping_std, 2);
    }
  }
  const double rms = std::sqrt(squares / (2 * kRecords * static_cast<double>(freq_Hz.size())));
  EXPECT_GE(rms, kMin);
  EXPECT_LE(rms, kMax);
}

}  // namespace percuss::identify::window_noise_test
