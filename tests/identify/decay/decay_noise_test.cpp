#include "identify/decay/decay_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"

namespace percuss::identify::decay_noise_test {

constexpr std::size_t kSamples = 32768;

// E|X(k)|² of noise x(n) = pole x(n − 1) + e(n), with e of unit variance.
double variance_of_line(double pole, double line) {
  return kSamples / std::norm(1.0 - pole * std::exp(Complex(0, -kTwoPi * line / kSamples)));
}

DecaySpectra noise_of(double pole, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  FreeDecays out{.fs_Hz = 48000, .hits = 1, .channels = 1, .response = {std::vector<double>(kSamples)}};
  double now = 0;
  for (int n = 0; n < 5000; ++n) now = pole * now + gauss(random);
  for (double& value : out.response[0]) value = now = pole * now + gauss(random);
  return decay_spectra(out);
}

// The noise of a room or of a phone's microphone falls with the frequency: here from line 26 on.
TEST(DecayNoise, FollowsNoiseThatFallsWithTheFrequency) {
  const double pole = 0.995;
  double worst = 0, mean = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Eigen::MatrixXd noise = decay_line_noise(noise_of(pole, seed), Eigen::VectorXd::Zero(1));
    for (const Eigen::Index k : {16, 40, 80, 160, 320, 640, 1280, 5000, 15000}) {
      const double ratio = std::log(noise(k, 0) / variance_of_line(pole, static_cast<double>(k)));
      worst = std::max(worst, std::abs(ratio));
      mean += ratio / (20 * 9);
    }
  }
  // The logarithm of a median of 32 exponential variables has the standard deviation 0.255. The limits are 4.7 times
  // this, and five times the standard deviation of a mean of 180 such values.
  EXPECT_LT(worst, 1.2);
  EXPECT_NEAR(mean, 0, 0.1);
}

constexpr unsigned kTrials = 20;
// Four standard deviations of a mean of kTrials smoothed values: one value has 0.048 at line 200, and less above.
constexpr double kNoiseOfMean = 0.043;  // 4 · 0.048/√20

/// The mean of smooth_noise_std over kTrials noises.
Eigen::VectorXd mean_noise_std(double pole) {
  Eigen::VectorXd sum = smooth_noise_std(decay_line_noise(noise_of(pole, 1), Eigen::VectorXd::Zero(1)));
  for (unsigned seed = 2; seed <= kTrials; ++seed)
    sum += smooth_noise_std(decay_line_noise(noise_of(pole, seed), Eigen::VectorXd::Zero(1)));
  return sum / kTrials;
}

TEST(DecayNoise, IsSmoothOverAnOctave) {
  const Eigen::VectorXd white = mean_noise_std(0);
  for (Eigen::Index k = 200; k < white.size(); k += 100) EXPECT_NEAR(white(k), 1, kNoiseOfMean) << k;
  const Eigen::VectorXd falling = mean_noise_std(0.995);
  // If the power of the noise falls with the square of the frequency, the average over an octave changes it by one
  // factor, the same at k and at 2k.
  for (const Eigen::Index k : {400, 800, 1600})
    EXPECT_NEAR(falling(2 * k) / falling(k),
                std::sqrt(variance_of_line(0.995, 2.0 * static_cast<double>(k)) /
                          variance_of_line(0.995, static_cast<double>(k))),
                kNoiseOfMean);
}

}  // namespace percuss::identify::decay_noise_test
