#include "acquire/hits/response_grade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/force_row.hpp"

namespace percuss::acquire::response_grade_test {

constexpr double kFs_Hz = 25600;
constexpr std::size_t kSamples = 12000;
constexpr std::size_t kOnset = 500;

Hit hit_at(std::size_t onset, std::size_t samples = kSamples) {
  std::vector<double> force(samples);
  test::add_haversine(force, static_cast<double>(onset), 8, 200);
  return find_hits(test::force_record(kFs_Hz, {force, force})).at(0);
}

const Hit& hit() {
  static const Hit one = hit_at(kOnset);
  return one;
}

/// peak · exp(−(n − onset)/τ) sin(0.2 (n − onset)), from its onset on.
std::vector<double> ringing(double tau, double peak = 50, std::size_t onset = kOnset, std::size_t samples = kSamples) {
  std::vector<double> x(samples);
  for (std::size_t n = onset; n < samples; ++n) {
    const auto t = static_cast<double>(n - onset);
    x[n] = peak * std::exp(-t / tau) * std::sin(0.2 * t);
  }
  return x;
}

std::size_t decayed(const Hit& hit, std::span<const double> accel) {
  return decayed_length(hit, accel.size(),
                        [&](std::size_t first, std::size_t count) { return accel.subspan(first, count); });
}

TEST(DecayedLength, IsZeroWithoutSamples) { EXPECT_EQ(decayed(hit(), {}), 0U); }

ResponseGrade grade(const std::vector<double>& accel) { return grade_response(hit(), accel, kFs_Hz); }

TEST(GradeResponse, MeasuresTheLevelAtTheEnd) {
  for (const double tau : {1000.0, 3000.0, 20000.0}) {
    const std::size_t after = hit().gate_first + hit().gated_N.size();
    const double window =
        std::floor(static_cast<double>(kSamples - after) / 20);  // samples of the first and of the last twentieth
    const double exact = -20 * std::log10(std::exp(1.0)) * (static_cast<double>(kSamples - after) - window) / tau;
    constexpr double kPhase_dB = 0.1;  // a window holds 18.3 periods, not a whole number
    EXPECT_LE(std::abs(grade(ringing(tau)).end_level_dB - exact), kPhase_dB) << tau;
  }
}

TEST(GradeResponse, IsTruncatedWhenTheRecordEndsBeforeSixTimeConstants) {
  EXPECT_TRUE(grade(ringing(2200)).truncated);   // −43 dB
  EXPECT_TRUE(grade(ringing(20000)).truncated);  // −5 dB
  EXPECT_FALSE(grade(ringing(1500)).truncated);  // −63 dB
}

// A decay that is rounded without noise ends in a constant. The rounding error is not noise.
TEST(GradeResponse, FindsStepsWithoutNoise) {
  const auto rounded = [](std::vector<double> x, double step) {
    for (double& value : x) value = step * std::round(value / step);
    return x;
  };
  const auto whole = ringing(600);
  const double largest = *std::max_element(whole.begin(), whole.end());  // not rounded, hence the tolerance of 2 %
  for (const double step : {1e-3, 0.5}) {
    EXPECT_NEAR(grade(rounded(ringing(600), step)).coarse_step * largest, step, 0.02 * step) << step;
    auto blurred = ringing(600);
    test::add_noise(blurred, step, 1);
    EXPECT_EQ(grade(rounded(blurred, step)).coarse_step, 0) << step;
  }
  EXPECT_EQ(grade(ringing(600)).coarse_step, 0);
  EXPECT_EQ(grade(ringing(20)).coarse_step, 0);  // decayed to zero
}

TEST(GradeResponse, IsNotTruncatedWhenOnlyNoiseRemains) {
  for (const double noise : {0.01, 0.3, 3.0}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      auto noisy = ringing(600);
      test::add_noise(noisy, noise, seed);
      EXPECT_FALSE(grade(noisy).truncated) << noise;
    }
    auto loud = ringing(20000);
    test::add_noise(loud, noise, 1);
    EXPECT_TRUE(grade(loud).truncated) << noise;
  }
}

TEST(GradeResponse, DistinguishesRingingFromNoiseWithoutAPretrigger) {
  const Hit early = hit_at(2);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto noisy = ringing(600, 50, 2);
    test::add_noise(noisy, 1.0, seed);
    EXPECT_FALSE(grade_response(early, noisy, kFs_Hz).truncated);
  }
  EXPECT_TRUE(grade_response(early, ringing(3000, 50, 2), kFs_Hz).truncated);
}

TEST(GradeResponse, FindsRingingBeforeTheHit) {
  auto earlier = ringing(1500);
  for (std::size_t n = 0; n < kSamples; ++n) {
    const auto t = static_cast<double>(n);
    earlier[n] += 4 * std::exp(-t / 1500) * std::cos(0.05 * t);
  }
  EXPECT_TRUE(grade(earlier).rings_before);
  EXPECT_FALSE(grade(ringing(1500)).rings_before);
  auto noisy = ringing(1500), disturbed = noisy;
  test::add_noise(noisy, 2, 3);
  EXPECT_FALSE(grade(noisy).rings_before);
  disturbed[100] += 1e-4;  // more than 52 dB below the response: negligible
  EXPECT_FALSE(grade(disturbed).rings_before);
}

TEST(GradeResponse, TakesTheFilterBeforeTheHitForNoMotion) {
  auto filtered = ringing(1500);
  for (std::size_t n = 1; n <= 60; ++n)
    filtered[hit().gate_first - n] += (n % 2 == 0 ? 1 : -1) * 4 / static_cast<double>(n);
  EXPECT_FALSE(grade(filtered).rings_before);
  EXPECT_FALSE(grade(filtered).may_ring_before);
}

// Blows that follow one another too soon: before each, the structure rings as at the end.
TEST(GradeResponse, FindsMotionBeforeTheHitOfACutDecay) {
  auto again = ringing(4000), noisy = again;  // ends at −24 dB
  for (std::size_t n = 0; n < kSamples; ++n) {
    const auto t = static_cast<double>(n);
    again[n] += 2 * std::exp(-t / 4000) * std::cos(0.05 * t);
  }
  EXPECT_FALSE(grade(again).rings_before);
  EXPECT_TRUE(grade(again).may_ring_before);
  test::add_noise(noisy, 1.5, 3);
  EXPECT_FALSE(grade(noisy).may_ring_before);
}

TEST(GradeResponse, MeasuresDelayAndDirectionOfTheFirstMotion) {
  const double onset = hit().onset_s * kFs_Hz;
  for (const double sign : {1.0, -1.0}) {
    for (const std::size_t late : {0U, 7U, 100U}) {
      const ResponseGrade found = grade(ringing(1000, sign * 50, kOnset + late));
      EXPECT_EQ(found.polarity, sign > 0 ? 1 : -1);
      ASSERT_TRUE(found.delay_s);
      constexpr double kSample = 1.001;  // samples: the delay is known to one sample; the rest is rounding
      // The delay ends at the first sample above 2 % of the largest: sin(0.2), one sample after the start.
      const double exact = static_cast<double>(kOnset + late + 1) - onset;
      EXPECT_LE(std::abs(*found.delay_s * kFs_Hz - exact), kSample) << late;
    }
  }
}

TEST(GradeResponse, IsEmptyForAChannelWithoutResponse) {
  for (const double level : {0.0, -3.25}) {
    const ResponseGrade found = grade(std::vector<double>(kSamples, level));
    EXPECT_EQ(found.polarity, 0);
    EXPECT_FALSE(found.delay_s);
    EXPECT_FALSE(found.truncated);
    EXPECT_FALSE(found.rings_before);
    EXPECT_EQ(found.clipped_samples, 0U);
  }
}

TEST(GradeResponse, FindsADeadChannel) {
  for (const double level : {0.0, -3.25}) EXPECT_TRUE(grade(std::vector<double>(kSamples, level)).dead);
  std::vector<double> nearly(kSamples);
  nearly[17] = 1e-300;
  EXPECT_FALSE(grade(nearly).dead);
  EXPECT_FALSE(grade(ringing(1000)).dead);
}

TEST(GradeResponse, DoesNotTakeRestForClipping) {
  for (const std::size_t onset : {kOnset, std::size_t{2}}) {  // with and without a pre-trigger
    std::vector<double> x(kSamples);
    for (std::size_t n = onset; n < onset + 400; ++n)
      x[n] = 30 + 20 * std::sin(0.2 * static_cast<double>(n - onset));  // one-sided
    EXPECT_EQ(grade_response(hit_at(onset), x, kFs_Hz).clipped_samples, 0U) << onset;
  }
}

// The filter makes the response ring before its onset, near half the sampling rate.
TEST(GradeResponse, IgnoresTheRingingOfTheFilter) {
  for (const double sign : {1.0, -1.0}) {
    for (const std::size_t start : {kOnset - 2, kOnset - 1, kOnset}) {
      auto x = ringing(1000, sign * 50);
      for (std::size_t n = start; n < kOnset + 4; ++n) x[n] += n % 2 == 0 ? 4 : -4;
      const ResponseGrade found = grade(x);
      EXPECT_EQ(found.polarity, sign > 0 ? 1 : -1) << start;
      ASSERT_TRUE(found.delay_s);
      EXPECT_GE(*found.delay_s, 0);
      EXPECT_LE(*found.delay_s, 3 / kFs_Hz);
    }
  }
}

// A far sensor that first moves a little the other way: neither direction is its first motion.
TEST(GradeResponse, StatesNoDirectionWhereALargerMotionFollowsTheOtherWay) {
  for (const double sign : {1.0, -1.0}) {
    auto x = ringing(1000, sign * 50);
    x[kOnset - 2] -= sign * 1;  // a sample of the lobe below the level that counts as motion
    x[kOnset - 1] -= sign * 8;
    x[kOnset] -= sign * 8;
    EXPECT_EQ(grade(x).polarity, 0);
    EXPECT_FALSE(grade(x).delay_s);
  }
}

TEST(GradeResponse, CountsClippedSamples) {
  auto clipped = ringing(2000);
  for (double& value : clipped) value = std::clamp(value, -30.0, 30.0);
  const auto expected = static_cast<std::size_t>(
      std::count_if(clipped.begin(), clipped.end(), [](double value) { return std::abs(value) == 30; }));
  ASSERT_GE(expected, 300U);
  EXPECT_EQ(grade(clipped).clipped_samples, expected);
  EXPECT_EQ(grade(ringing(2000)).clipped_samples, 0U);
}

TEST(GradeResponse, DoesNotDependOnUnitOrOffset) {
  auto x = ringing(2500);
  test::add_noise(x, 0.05, 8);
  const ResponseGrade plain = grade(x);
  for (const double scale : {-0x1p-100, 0x1p100}) {  // 1e-30 … 1e30
    auto scaled = x;
    for (double& value : scaled) value *= scale;
    const ResponseGrade found = grade(scaled);
    EXPECT_DOUBLE_EQ(found.end_level_dB, plain.end_level_dB);
    EXPECT_EQ(found.truncated, plain.truncated);
    EXPECT_EQ(found.delay_s, plain.delay_s);
    EXPECT_EQ(found.polarity, scale < 0 ? -plain.polarity : plain.polarity);
  }
  for (double& value : x) value += 400;
  EXPECT_LE(std::abs(grade(x).end_level_dB - plain.end_level_dB), 1e-9);  // rounding about the mean
  EXPECT_EQ(grade(x).delay_s, plain.delay_s);
}

TEST(GradeResponse, AcceptsPulsesAtTheVeryEndAndShortSignals) {
  for (const std::size_t samples : {3U, 40U, 200U, 5000U}) {
    for (const std::size_t left : {0U, 1U, 2U, 9U}) {
      if (left >= samples) continue;
      std::vector<double> force(samples), accel(samples, 0.5);
      force[samples - 1 - left] = 10;
      accel.back() = 4;
      const Hit late = find_hits(test::force_record(kFs_Hz, {force, force})).at(0);
      EXPECT_FALSE(grade_response(late, accel, kFs_Hz).rings_before);
      EXPECT_EQ(decayed(late, accel), samples);
    }
  }
  const ResponseGrade none = grade(std::vector<double>(kOnset / 2, 1.0));  // ends before the pulse
  EXPECT_EQ(none.polarity, 0);
}

TEST(GradeResponse, TakesNoMotionLongAfterTheForceForItsEffect) {
  auto x = ringing(600, 50, kOnset + 9000);  // 0.35 s after the force: it cannot be its effect
  test::add_noise(x, 1e-3, 1);
  EXPECT_FALSE(grade(x).delay_s);
  EXPECT_EQ(grade(x).polarity, 0);
  EXPECT_TRUE(grade(ringing(600, 50, kOnset + 500)).delay_s);  // 20 ms
}

TEST(DecayedLength, IsTwiceTheTimeToTheBackground) {
  constexpr double kTau = 300, kNoise = 0.05;
  auto x = ringing(kTau);
  test::add_noise(x, kNoise, 2);
  // rms² = peak² e^(−2t/τ)/2 + σ² is (2σ)² at:
  const double settled = kTau * std::log(50 / std::sqrt(6.0) / kNoise);
  const auto after = static_cast<double>(hit().gate_first + hit().gated_N.size());
  const double window = (kSamples - after) / 64;
  const double exact = after + 2 * (static_cast<double>(kOnset) + settled - after);
  EXPECT_LE(std::abs(static_cast<double>(decayed(hit(), x)) - exact), 2.5 * window);  // whole windows, twice
}

TEST(DecayedLength, IsTheWholeSignalWhileItFallsOrIsShort) {
  for (const double tau : {1e6, 20000.0, 9000.0, 7500.0, 7000.0, 5000.0}) {
    EXPECT_EQ(decayed(hit(), ringing(tau)), kSamples) << tau;
  }
  EXPECT_EQ(decayed(hit(), ringing(1000)), kSamples);  // no background at all
  EXPECT_EQ(decayed(hit(), std::vector<double>(kSamples)), kSamples);
  EXPECT_EQ(decayed(hit_at(20, 300), ringing(10, 50, 20, 300)), 300U);
}

TEST(DecayedLength, IsShortForAChannelWithNoiseOnly) {
  std::vector<double> x(kSamples);
  test::add_noise(x, 0.3, 6);
  EXPECT_LE(decayed(hit(), x), kSamples / 10);
}

TEST(AddResponseFindings, NamesTheWorstChannel) {
  Hit mine = hit();
  add_response_findings(mine, {{.end_level_dB = -80},
                               {.end_level_dB = -30, .truncated = true},
                               {.end_level_dB = -20, .truncated = true},
                               {.end_level_dB = -5}});
  ASSERT_EQ(mine.findings.size(), 1U);
  EXPECT_EQ(mine.findings[0].code, FindingCode::truncated_decay);
  EXPECT_EQ(mine.findings[0].severity, Severity::warn);
  EXPECT_EQ(mine.findings[0].value, -20);
  Hit clipped = hit();
  add_response_findings(clipped, {{.clipped_samples = 3}, {.clipped_samples = 11}, {}});
  ASSERT_EQ(clipped.findings.size(), 1U);
  EXPECT_EQ(clipped.findings[0].code, FindingCode::overload);
  EXPECT_EQ(clipped.findings[0].severity, Severity::reject);
  EXPECT_EQ(clipped.findings[0].value, 11);
  Hit good = hit();
  add_response_findings(good, {{.end_level_dB = -90}, {}});
  add_response_findings(good, {});
  EXPECT_TRUE(good.findings.empty());
}

}  // namespace percuss::acquire::response_grade_test
