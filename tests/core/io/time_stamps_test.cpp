#include "core/io/time_stamps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include <cmath>
#include <random>

namespace percuss::time_stamps_test {

using testing::HasSubstr;

std::vector<double> rounded_stamps(double fs_Hz, std::size_t count, double resolution_s) {
  std::vector<double> t(count);
  for (std::size_t i = 0; i < count; ++i)
    t[i] = std::round(static_cast<double>(i) / fs_Hz / resolution_s) * resolution_s;
  return t;
}

std::optional<StampedRate> rate_of(const std::vector<double>& time_s, double resolution_s,
                                   std::string* problem = nullptr) {
  const std::vector<TimeStamps> rows = {{time_s, resolution_s}};
  StampProblem found;
  auto rate = rate_of_time_stamps(rows, found);
  if (problem != nullptr) *problem = found.text;
  EXPECT_EQ(rate.has_value(), found.text.empty());
  return rate;
}

TEST(RateOfTimeStamps, IsExactForAnyRoundingOfTheStamps) {
  for (const double fs_Hz : {50.0, 1000.0, 25600.0, 44100.0, 51200.0, 102400.0}) {
    for (const double resolution_s : {1e-9, 1e-6, 1e-4}) {
      const auto rate = rate_of(rounded_stamps(fs_Hz, 200000, resolution_s), resolution_s);
      ASSERT_TRUE(rate) << fs_Hz << ' ' << resolution_s;
      EXPECT_EQ(rate->fs_Hz, fs_Hz) << resolution_s;
    }
  }
}

// At 10240 Hz, every 43rd stamp or so repeats the one before it.
TEST(RateOfTimeStamps, AcceptsRepeatedStampsOfARateAboveOneSamplePerUnit) {
  for (const double fs_Hz : {10240.0, 12800.0, 10100.0}) {
    const auto rate = rate_of(rounded_stamps(fs_Hz, 20000, 1e-4), 1e-4);
    ASSERT_TRUE(rate) << fs_Hz;
    EXPECT_EQ(rate->fs_Hz, fs_Hz);
  }
}

TEST(RateOfTimeStamps, RejectsRepeatedStampsThatRoundingDoesNotExplain) {
  std::string problem;
  for (const std::size_t repeated : {1U, 8U}) {
    auto t = rounded_stamps(1e4, 20000, 1e-4);
    for (std::size_t i = 0; i < repeated; ++i) {
      const auto at = t.begin() + static_cast<std::ptrdiff_t>(100 + 41 * i * i);
      t.insert(at, *at);
    }
    EXPECT_FALSE(rate_of(t, 1e-4, &problem)) << repeated;
    EXPECT_THAT(problem, HasSubstr("does not rise"));
  }
  for (const std::size_t lost : {1U, 777U, 19998U}) {
    auto t = rounded_stamps(10240, 20000, 1e-4);
    t.erase(t.begin() + static_cast<std::ptrdiff_t>(lost));
    EXPECT_FALSE(rate_of(t, 1e-4, &problem)) << lost;
  }
  auto falling = rounded_stamps(10240, 20000, 1e-4);
  std::swap(falling[500], falling[501]);
  EXPECT_FALSE(rate_of(falling, 1e-4, &problem));
}

TEST(RateOfTimeStamps, NeedsFewStampsWhereTheyAreExact) {
  EXPECT_EQ(rate_of({0, 1e-3}, 1e-3)->fs_Hz, 1000);
  EXPECT_EQ(rate_of({0.5, 0.75, 1}, 0.01)->fs_Hz, 4);
}

TEST(RateOfTimeStamps, AcceptsSinglePrecision) {
  std::vector<double> t(200000);
  for (std::size_t i = 0; i < t.size(); ++i)
    t[i] = static_cast<double>(static_cast<float>(static_cast<double>(i) / 25600.0));
  const auto rate = rate_of(t, 1e-16);
  ASSERT_TRUE(rate);
  EXPECT_NEAR(rate->fs_Hz / 25600, 1, 0x1p-23);  // two roundings to 24 bits
}

TEST(RateOfTimeStamps, FindsEveryLostSample) {
  for (const std::size_t lost : {std::size_t{1}, std::size_t{500}, std::size_t{998}}) {
    for (const double resolution_s : {1e-6, 1e-5, 1e-3}) {
      auto t = rounded_stamps(resolution_s == 1e-3 ? 1000 : 25600, 20000, resolution_s);
      t.erase(t.begin() + static_cast<std::ptrdiff_t>(lost));
      std::string problem;
      EXPECT_FALSE(rate_of(t, resolution_s, &problem)) << lost << ' ' << resolution_s;
      EXPECT_THAT(problem, HasSubstr("uneven time"));
    }
  }
}

std::vector<StampGap> gaps_in(std::vector<double> t, const std::vector<std::size_t>& lost, double resolution_s,
                              std::optional<double> fs_Hz = {}) {
  for (auto at = lost.rbegin(); at != lost.rend(); ++at) t.erase(t.begin() + static_cast<std::ptrdiff_t>(*at));
  return gaps_of_stamps({t, resolution_s}, fs_Hz);
}

TEST(GapsOfStamps, AreTheLostLines) {
  const auto t = rounded_stamps(25600, 20000, 1e-7);
  EXPECT_TRUE(gaps_in(t, {}, 1e-7).empty());
  const auto gaps = gaps_in(t, {1, 500, 700, 701, 702}, 1e-7);
  ASSERT_EQ(gaps.size(), 3U);
  EXPECT_EQ(gaps[0].at, 1U);
  EXPECT_EQ(gaps[0].count, 1U);
  EXPECT_EQ(gaps[1].at, 499U);
  EXPECT_EQ(gaps[2].at, 698U);
  EXPECT_EQ(gaps[2].count, 3U);
  std::vector<double> left = t;
  left.erase(left.begin() + 500, left.begin() + 540);
  const auto filled = with_missing_stamps(left, gaps_of_stamps({left, 1e-7}));
  ASSERT_EQ(filled.size(), t.size());
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(filled[i], t[i], 1e-7);
}

TEST(GapsOfStamps, AreNoneWhereTheStepsAreNoWholeNumber) {
  auto t = rounded_stamps(25600, 2000, 1e-7);
  for (std::size_t i = 1000; i < t.size(); ++i) t[i] += 0.5 / 25600;
  EXPECT_TRUE(gaps_of_stamps({t, 1e-7}).empty());
  auto many = rounded_stamps(25600, 2000, 1e-7);
  std::vector<std::size_t> third;
  for (std::size_t i = 1; i + 1 < many.size(); i += 3) third.push_back(i);
  EXPECT_TRUE(gaps_in(many, third, 1e-7).empty()) << "more than a tenth is missing";
}

// One step of two units among steps of one unit: a sample of 1000 Hz was lost, or the rate is just below.
TEST(GapsOfStamps, NeedTheRateWhereTheDigitsAreFew) {
  const auto t = rounded_stamps(1000, 5000, 1e-3);
  EXPECT_TRUE(gaps_in(t, {700}, 1e-3).empty());
  const auto gaps = gaps_in(t, {700}, 1e-3, 1000);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].at, 700U);
  EXPECT_TRUE(gaps_of_stamps({rounded_stamps(999.8, 5000, 1e-3), 1e-3}, 999.8).empty());
}

TEST(RateOfTimeStamps, RejectsTimeThatDoesNotRise) {
  std::string problem;
  EXPECT_FALSE(rate_of({0, 1e-3, 2e-3, 0, 1e-3, 2e-3}, 1e-3, &problem));
  EXPECT_THAT(problem, HasSubstr("does not rise"));
  EXPECT_FALSE(rate_of({0.5, 0.5, 0.5}, 1e-3, &problem));
  EXPECT_FALSE(rate_of({1, 0.9, 0.8}, 1e-3, &problem));
  EXPECT_FALSE(rate_of({0}, 1e-3, &problem));
}

TEST(RateOfTimeStamps, RejectsStampsThatAreTooCoarse) {
  std::string problem;
  EXPECT_FALSE(rate_of(rounded_stamps(25600, 2560, 1e-3), 1e-3, &problem));
  EXPECT_THAT(problem, HasSubstr("too coarse"));
}

TEST(RateOfTimeStamps, CombinesRowsThatStartAgain) {
  const auto t = rounded_stamps(12800, 1280, 1e-9);
  const std::vector<TimeStamps> rows(5, {t, 1e-9});
  StampProblem problem;
  EXPECT_EQ(rate_of_time_stamps(rows, problem)->fs_Hz, 12800);
}

TEST(RateOfTimeStamps, RejectsRowsOfDifferentRates) {
  const auto t = rounded_stamps(12800, 1280, 1e-9), drifted = rounded_stamps(12800 * (1 + 1e-4), 1280, 1e-9);
  const auto other = rounded_stamps(12800 * (1 + 2e-3), 1280, 1e-9);
  StampProblem problem;
  EXPECT_TRUE(rate_of_time_stamps(std::vector<TimeStamps>{{t, 1e-9}, {drifted, 1e-9}}, problem)) << "a clock may drift";
  EXPECT_FALSE(rate_of_time_stamps(std::vector<TimeStamps>{{t, 1e-9}, {t, 1e-9}, {other, 1e-9}}, problem));
  EXPECT_EQ(problem.kind, StampProblemKind::rates_differ);
  EXPECT_EQ(problem.row, 2U);
  EXPECT_THAT(problem.text, HasSubstr("another sampling rate"));
}

TEST(RoundestBetween, HasTheFewestDigits) {
  EXPECT_EQ(roundest_between(25599.2, 25600.7), 25600);
  EXPECT_EQ(roundest_between(99, 101), 100);
  EXPECT_EQ(roundest_between(48828.1249, 48828.1251), 48828.125);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-3, 8), width(1e-12, 1e-3);
  for (int i = 0; i < 1000; ++i) {
    const double low = std::pow(10, exponent(random)), high = low * (1 + width(random));
    const double round = roundest_between(low, high);
    EXPECT_TRUE(low <= round && round <= high) << low << ' ' << high << ' ' << round;
  }
}

// An infinite stamp gives a rate of 0, a step of 5e-324 s an infinite rate. The logarithm of such a rate is infinite;
// its conversion to int would be undefined.
TEST(TimeStamps, MustBeFinite) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& time_s : {std::vector{38, kInfinite}, {0, 5e-324}}) {
    StampProblem problem;
    EXPECT_FALSE(rate_of_time_stamps(std::vector<TimeStamps>{{time_s, 0}}, problem));
    EXPECT_NE(problem.text, "");
  }
}

}  // namespace percuss::time_stamps_test
