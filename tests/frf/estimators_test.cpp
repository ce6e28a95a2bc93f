#include "frf/estimators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>

#include "support/input_error.hpp"

namespace percuss::frf::estimators_test {

using Lines = std::vector<Complex>;
constexpr LineRange kLines{.fs_Hz = 1000, .samples = 500, .first = 10, .count = 0};
constexpr std::array kEstimators = {Estimator::h1, Estimator::h2, Estimator::hv};

/// Spectra of several hits, [hits][lines].
struct Hits {
  std::vector<Lines> force, accel;
  CrossSpectra sums() const {
    const std::vector<std::span<const Complex>> f(force.begin(), force.end()), a(accel.begin(), accel.end());
    return cross_spectra(f, a);
  }
  Frf frf(Estimator estimator) const { return estimate_frf(sums(), kLines, estimator); }
};

class Noise {
 public:
  explicit Noise(std::uint64_t seed) : generator_(seed) {}
  /// A complex value with this mean square.
  Complex operator()(double power) {
    const double deviation = std::sqrt(power / 2);
    const double real = normal_(generator_);
    return deviation * Complex(real, normal_(generator_));
  }

 private:
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
};

Complex true_frf(std::size_t line) {
  return std::polar(0.5 + static_cast<double>(line % 7), 0.3 * static_cast<double>(line));
}

/// Hits of different forces of mean square 1, whose responses follow true_frf. The noise powers are relative to the
/// force.
Hits simulated(std::size_t hits, std::size_t lines, double force_noise, double accel_noise, std::uint64_t seed = 1) {
  Noise noise(seed);
  Hits out{std::vector<Lines>(hits, Lines(lines)), std::vector<Lines>(hits, Lines(lines))};
  for (std::size_t h = 0; h < hits; ++h) {
    for (std::size_t k = 0; k < lines; ++k) {
      const Complex force = noise(1);
      out.force[h][k] = force + noise(force_noise);
      out.accel[h][k] = true_frf(k) * (force + noise(accel_noise));
    }
  }
  return out;
}

TEST(EstimateFrf, FollowsItsEquationsOnTwoHits) {
  const Hits hits{{{1.0}, {1.0}}, {{2.0}, {4.0}}};  // G_ff = 2, G_aa = 20, G_fa = 6
  EXPECT_DOUBLE_EQ(hits.frf(Estimator::h1).value[0].real(), 3);
  EXPECT_DOUBLE_EQ(hits.frf(Estimator::h2).value[0].real(), 20.0 / 6);
  // Hv scales both channels to equal power, so that the regression line is at 45°.
  EXPECT_DOUBLE_EQ(hits.frf(Estimator::hv).value[0].real(), std::sqrt(10.0));
  EXPECT_DOUBLE_EQ(hits.frf(Estimator::h1).coherence[0], 0.9);
  EXPECT_DOUBLE_EQ(hits.frf(Estimator::h1).std[0], 1);
  EXPECT_EQ(hits.frf(Estimator::h1).averages, 2U);
}

TEST(EstimateFrf, IsResponseOverForceNotItsConjugate) {
  const Hits hits{{{1.0}, {Complex(0, 2)}}, {{Complex(0, -3)}, {6.0}}};  // A = −3j F: the response lags
  for (const Estimator estimator : kEstimators) {
    EXPECT_LE(std::abs(hits.frf(estimator).value[0] - Complex(0, -3)), 1e-15) << name_of(estimator);  // rounding
  }
}

TEST(EstimateFrf, IsExactWithoutNoise) {
  const Hits hits = simulated(3, 200, 0, 0);
  for (const Estimator estimator : kEstimators) {
    const Frf frf = hits.frf(estimator);
    for (std::size_t k = 0; k < 200; ++k) {
      const double magnitude = std::abs(true_frf(k));
      constexpr double kRounding = 1e-14;  // of sums of three products
      ASSERT_LE(std::abs(frf.value[k] - true_frf(k)), kRounding * magnitude) << name_of(estimator);
      ASSERT_LE(1 - frf.coherence[k], kRounding);
      ASSERT_LE(frf.std[k], 1e-7 * magnitude);  // the root of that rounding
    }
  }
}

TEST(EstimateFrf, OrdersTheEstimatorsByMagnitudeAtOnePhase) {
  const Hits hits = simulated(5, 500, 0.05, 0.1);
  const Frf h1 = hits.frf(Estimator::h1), h2 = hits.frf(Estimator::h2), hv = hits.frf(Estimator::hv);
  for (std::size_t k = 0; k < 500; ++k) {
    ASSERT_LE(std::abs(h1.value[k]), std::abs(hv.value[k]));
    ASSERT_LE(std::abs(hv.value[k]), std::abs(h2.value[k]));
    constexpr double kRounding = 1e-13;  // rad
    ASSERT_LE(std::abs(std::arg(hv.value[k] / h1.value[k])), kRounding);
    ASSERT_LE(std::abs(std::arg(h2.value[k] / h1.value[k])), kRounding);
    ASSERT_LE(std::abs(h1.value[k] / h2.value[k] - h1.coherence[k]), kRounding);  // H1/H2 = γ²
  }
}

TEST(EstimateFrf, IsUnbiasedByTheNoiseItAllowsFor) {
  constexpr std::size_t kHits = 4000;
  const auto mean_gain = [](const Frf& frf) {
    double sum = 0;
    for (std::size_t k = 0; k < frf.value.size(); ++k) sum += (frf.value[k] / true_frf(k)).real();
    return sum / static_cast<double>(frf.value.size());
  };
  const Hits on_accel = simulated(kHits, 20, 0, 0.2), on_force = simulated(kHits, 20, 0.2, 0);
  const double kFiveDeviations = 5 * std::sqrt(0.2 / 2 / (kHits * 20.0));  // of the real part of the mean gain
  EXPECT_LE(std::abs(mean_gain(on_accel.frf(Estimator::h1)) - 1), kFiveDeviations);
  EXPECT_LE(std::abs(mean_gain(on_force.frf(Estimator::h2)) - 1), kFiveDeviations);
  EXPECT_GE(mean_gain(on_accel.frf(Estimator::h2)) - 1, 0.15);   // 0.2, the noise power
  EXPECT_LE(mean_gain(on_force.frf(Estimator::h1)) - 1, -0.10);  // 1/1.2 − 1
}

TEST(EstimateFrf, TakesTheInverseWhenTheChannelsAreSwapped) {
  const Hits hits = simulated(4, 100, 0.1, 0.1);
  const Hits swapped{hits.accel, hits.force};
  for (std::size_t k = 0; k < 100; ++k) {
    constexpr double kRounding = 1e-13;  // of sums of four products
    const Complex one = hits.frf(Estimator::h1).value[k] * swapped.frf(Estimator::h2).value[k];
    const Complex total = hits.frf(Estimator::hv).value[k] * swapped.frf(Estimator::hv).value[k];
    ASSERT_LE(std::abs(one - 1.0), kRounding);
    ASSERT_LE(std::abs(total - 1.0), kRounding);
  }
}

TEST(EstimateFrf, DoesNotDependOnUnitsOrTheOrderOfHits) {
  const Hits hits = simulated(4, 60, 0.1, 0.2);
  Hits reversed = hits;
  std::reverse(reversed.force.begin(), reversed.force.end());
  std::reverse(reversed.accel.begin(), reversed.accel.end());
  for (const auto& [force, accel] :
       {std::pair{1.0, -1.0}, {1e-30, 1e30}, {1e30, 1e-30}, {1e30, 1e30}, {1e-30, 1e-30}}) {
    Hits scaled = reversed;
    for (Lines& lines : scaled.force) std::for_each(lines.begin(), lines.end(), [f = force](Complex& x) { x *= f; });
    for (Lines& lines : scaled.accel) std::for_each(lines.begin(), lines.end(), [a = accel](Complex& x) { x *= a; });
    for (const Estimator estimator : kEstimators) {
      const Frf plain = hits.frf(estimator), other = scaled.frf(estimator);
      for (std::size_t k = 0; k < 60; ++k) {
        constexpr double kRounding = 1e-12;  // of sums of a few products
        ASSERT_LE(std::abs(other.value[k] * (force / accel) / plain.value[k] - 1.0), kRounding)
            << force << ' ' << accel;
        ASSERT_LE(std::abs(other.std[k] * std::abs(force / accel) / plain.std[k] - 1), kRounding);
        ASSERT_LE(std::abs(other.coherence[k] - plain.coherence[k]), kRounding);
      }
    }
  }
}

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

TEST(Coherence, OfUnrelatedNoiseIsOneOverTheHits) {
  constexpr std::size_t kLineCount = 20000;
  for (const double n : {2.0, 5.0, 20.0}) {
    Noise noise(7);
    const auto hits = static_cast<std::size_t>(n);
    Hits unrelated{std::vector<Lines>(hits, Lines(kLineCount)), std::vector<Lines>(hits, Lines(kLineCount))};
    for (auto* side : {&unrelated.force, &unrelated.accel}) {
      for (Lines& lines : *side) std::generate(lines.begin(), lines.end(), [&] { return noise(1); });
    }
    const double deviation = std::sqrt((n - 1) / (n * n * (n + 1)) / kLineCount);  // of a mean of Beta(1, n − 1)
    EXPECT_LE(std::abs(mean(unrelated.frf(Estimator::h1).coherence) - 1 / n), 5 * deviation) << n;
  }
}

TEST(Coherence, OfManyHitsFollowsFromTheirNoise) {
  constexpr double kHits = 2000, kLineCount = 50;
  const Frf frf = simulated(2000, 50, 0.25, 0.5).frf(Estimator::h1);
  const double exact = 1 / (1.25 * 1.5);
  const double deviation = std::sqrt(2 * exact) * (1 - exact) / std::sqrt(kHits * kLineCount);
  const double bias = (1 - exact) * (1 - exact) / kHits;
  EXPECT_LE(std::abs(mean(frf.coherence) - exact), 5 * deviation + bias);
}

TEST(FrfStd, IsTheDeviationFromTheTruth) {
  constexpr double kRepetitions = 20000, kHits = 5;  // each line is one repetition
  Noise noise(11);
  Hits hits{std::vector<Lines>(5, Lines(20000)), std::vector<Lines>(5, Lines(20000))};
  const Complex truth(-2, 1);
  for (std::size_t h = 0; h < 5; ++h) {
    for (std::size_t k = 0; k < 20000; ++k) {
      hits.force[h][k] = std::polar(1 + static_cast<double>(h), static_cast<double>(k));  // no noise
      hits.accel[h][k] = truth * hits.force[h][k] + noise(0.7);
    }
  }
  const Frf frf = hits.frf(Estimator::h1);
  double scatter = 0, claimed = 0;
  for (std::size_t k = 0; k < 20000; ++k) {
    scatter += std::norm(frf.value[k] - truth);
    claimed += frf.std[k] * frf.std[k];
  }
  // χ² of 2 and 2(n − 1) degrees of freedom for each line.
  const double deviation = std::sqrt((1 + 1 / (kHits - 1)) / kRepetitions);
  EXPECT_LE(std::abs(claimed / scatter - 1), 5 * deviation);
}

TEST(EstimateFrf, OfOneHitHasNoScatter) {
  const Frf frf = Hits{{{2.0, 1.0}}, {{4.0, 3.0}}}.frf(Estimator::hv);
  EXPECT_TRUE(frf.std.empty());
  EXPECT_TRUE(frf.coherence.empty());
  constexpr double kRounding = 1e-15;
  EXPECT_LE(std::abs(frf.value[0] - 2.0), 2 * kRounding);
}

TEST(EstimateFrf, IsZeroWhereNothingResponds) {
  const Hits silent{{{1.0}, {2.0}}, {{0.0}, {0.0}}};
  for (const Estimator estimator : kEstimators) {
    const Frf frf = silent.frf(estimator);
    EXPECT_EQ(frf.value[0], 0.0);
    EXPECT_EQ(frf.coherence[0], 0);
    EXPECT_EQ(frf.std[0], 0);
  }
}

TEST(EstimateFrf, RefusesALineWithoutForce) {
  const Hits hits{{{1.0, 0.0}, {2.0, 0.0}}, {{1.0, 1.0}, {1.0, 1.0}}};
  for (const Estimator estimator : kEstimators) {
    const std::string message = test::input_error_of([&] { hits.frf(estimator); });
    EXPECT_THAT(message, testing::HasSubstr("22 Hz"));  // line 10 + 1, 2 Hz apart
    EXPECT_THAT(test::options_of_error([&] { hits.frf(estimator); }), testing::ElementsAre("band"));
  }
}

TEST(Estimator, HasTheNamesOfTheField) {
  EXPECT_STREQ(name_of(Estimator::h1), "H1");
  EXPECT_STREQ(name_of(Estimator::h2), "H2");
  EXPECT_STREQ(name_of(Estimator::hv), "Hv");
}

}  // namespace percuss::frf::estimators_test
