#include "identify/decay/noise_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"

namespace percuss::identify::noise_prediction_test {

constexpr std::size_t kSamples = 4096;
constexpr double kPole = 0.9, kStd = 0.3;

// E|X(k)|² of noise x(n) = kPole x(n − 1) + e(n), with e of the standard deviation kStd.
Eigen::VectorXd line_variance() {
  Eigen::VectorXd out(kSamples / 2 + 1);
  for (Eigen::Index k = 0; k < out.size(); ++k) {
    const double phase = kTwoPi * static_cast<double>(k) / kSamples;
    out(k) = kSamples * kStd * kStd / std::norm(1.0 - kPole * std::exp(Complex(0, -phase)));
  }
  return out;
}

// Read backwards, a first-order process has the same spectrum, and thus the same prediction.
TEST(NoisePrediction, IsThatOfAFirstOrderProcess) {
  const NoisePrediction prediction = noise_prediction(line_variance(), kSamples);
  ASSERT_FALSE(prediction.weight.empty());
  EXPECT_NEAR(prediction.weight[0], kPole, 1e-6);
  for (std::size_t i = 1; i < prediction.weight.size(); ++i) EXPECT_NEAR(prediction.weight[i], 0, 1e-6) << i;
  EXPECT_NEAR(prediction.error_variance, kStd * kStd, 1e-6 * kStd * kStd);
}

TEST(NoisePrediction, LeavesWhiteErrors) {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  std::vector<double> x(kSamples);
  double now = 0;
  for (double& value : x) value = now = kPole * now + kStd * gauss(random);
  const NoisePrediction prediction = noise_prediction(line_variance(), kSamples);
  double square = 0, neighbours = 0, last = 0;
  for (std::size_t n = 0; n < kSamples - 16; ++n) {
    const double error = prediction.error(x, n);
    square += error * error;
    neighbours += error * last;
    last = error;
  }
  // Four standard deviations of the mean square and of the correlation of 4080 independent normal values.
  EXPECT_NEAR(square / kSamples, kStd * kStd, 4 * std::sqrt(2.0 / kSamples) * kStd * kStd);
  EXPECT_NEAR(neighbours / square, 0, 4 / std::sqrt(static_cast<double>(kSamples)));
}

// The error of exp(snΔ) is exp(snΔ) (1 − kPole exp(sΔ)).
TEST(NoisePrediction, StatesTheErrorOfADecay) {
  const Complex rate(-30, 900);
  const double fs_Hz = 2000;
  EXPECT_NEAR(noise_prediction(line_variance(), kSamples).gain({rate}, fs_Hz),
              std::norm(1.0 - kPole * std::exp(rate / fs_Hz)), 1e-5);
}

}  // namespace percuss::identify::noise_prediction_test
