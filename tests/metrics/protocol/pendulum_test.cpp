#include "metrics/protocol/pendulum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "synth/random_stream.hpp"

namespace percuss::metrics::pendulum_test {

constexpr double kPeriod_s = 1.4321, kRounding = 1e-12;

// Crossings of a gate beside the position of rest: the two intervals of a period differ.
std::vector<double> crossings(std::size_t count, double aside) {
  std::vector<double> times;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t whole = n / 2;
    times.push_back(0.3 + kPeriod_s * (static_cast<double>(whole) + (n % 2 == 1 ? 0.5 + aside : 0)));
  }
  return times;
}

TEST(Pendulum, RecoversThePeriodFromExactCrossings) {
  for (const double aside : {0.0, 0.1, -0.2}) {
    for (const std::size_t count : {3U, 4U, 21U}) {
      const PeriodEstimate got = period_of_crossings(crossings(count, aside));
      EXPECT_EQ(got.problem, "");
      EXPECT_NEAR(got.period_s, kPeriod_s, kRounding) << aside;
      EXPECT_NEAR(got.std_s, 0, kRounding);
    }
  }
}

TEST(Pendulum, AcceptsOneCrossingPerPeriod) {
  EXPECT_NEAR(period_of_crossings({0.1, 0.1 + kPeriod_s, 0.1 + 2 * kPeriod_s}, 1).period_s, kPeriod_s, kRounding);
}

TEST(Pendulum, StatesTheScatterOfManySeries) {
  constexpr double kNoise_s = 1e-3;
  double squares = 0, stated = 0;
  const int series = 2000;
  for (int s = 0; s < series; ++s) {
    auto times = crossings(12, 0.05);
    synth::RandomStream random{7, static_cast<std::uint64_t>(s)};
    random.add_normal(kNoise_s, times);
    const PeriodEstimate got = period_of_crossings(times);
    squares += std::pow(got.period_s - kPeriod_s, 2) / series;
    stated += got.std_s * got.std_s / series;
  }
  // The measured variance of 2000 series has a standard deviation of 3.2 % (√(2/2000)), the stated one a smaller one.
  constexpr double kFiveDeviations = 0.16;
  EXPECT_NEAR(stated / squares, 1, kFiveDeviations);
}

TEST(Pendulum, StatesAtLeastTheErrorOfReading) {
  const PeriodEstimate coarse = period_of_crossings(crossings(3, 0), 2, 0.01);
  // Two times of one direction: σ_T = √2 σ_t, σ_t = 0.01/√12; the single time of the other direction adds nothing.
  EXPECT_NEAR(coarse.std_s, std::sqrt(2.0) * 0.01 / std::sqrt(12.0), kRounding);
}

TEST(Pendulum, AveragesReadings) {
  const PeriodEstimate got = mean_period({1.40, 1.44, 1.42});
  EXPECT_NEAR(got.period_s, 1.42, kRounding);
  EXPECT_NEAR(got.std_s, 0.02 / std::sqrt(3.0), kRounding);
  EXPECT_NEAR(mean_period({1.4}, 0.01).std_s, 0.01 / std::sqrt(12.0), kRounding);
}

TEST(Pendulum, TakesEqualReadingsForNoProofOfPrecision) {
  EXPECT_NEAR(mean_period({1.39, 1.39}, 0.01).std_s, 0.01 / std::sqrt(12.0), kRounding) << "one rounding error";
  EXPECT_EQ(mean_period({1.39, 1.39}).std_s, 0);
  EXPECT_EQ(period_of_crossings({0.10, 0.79, 1.49, 2.18, 2.88}).std_s, 0) << "unknown, not the error of a computation";
}

TEST(Pendulum, StatesTheReasonForNoPeriod) {
  using testing::HasSubstr;
  EXPECT_THAT(mean_period({}).problem, HasSubstr("no period"));
  EXPECT_THAT(period_of_crossings({1, 2}).problem, HasSubstr("needs at least 3"));
  EXPECT_THAT(period_of_crossings({1, 2, 2}).problem, HasSubstr("time 3 does not come after time 2"));
  EXPECT_THAT(period_of_crossings({1, 2, std::nan("")}).problem, HasSubstr("time 3"));
  auto lost = crossings(12, 0.05);
  lost.erase(lost.begin() + 5);
  EXPECT_THAT(period_of_crossings(lost).problem, HasSubstr("missing or counted twice"));
}

}  // namespace percuss::metrics::pendulum_test
