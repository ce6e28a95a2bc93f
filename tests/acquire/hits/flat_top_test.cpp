#include "acquire/hits/flat_top.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/force_row.hpp"

namespace percuss::acquire::flat_top_test {

constexpr double kFs_Hz = 25600;
constexpr std::size_t kSamples = 6000, kFine = 16;
constexpr std::size_t kFilterReach = 20;  // samples on either side of the filter's centre

/// sin² (a haversine) or sin (a half-sine), cut off at `level` of its peak, after a recorder's linear-phase anti-alias
/// filter: 16 times oversampled, filtered by a windowed sinc with its cut-off at 0.45 of the sampling rate, then every
/// 16th sample.
std::vector<double> cut_row(double width, double level, double peak_N, std::uint64_t seed, double power = 2) {
  constexpr double kOnset = 500.3;
  const auto fine = [&](double t) {
    const double phase = (t - kOnset) / width;
    return phase <= 0 || phase >= 1 ? 0.0
                                    : std::min(level, std::pow(std::sin(std::numbers::pi * phase), power)) * peak_N;
  };
  std::vector<double> x(kSamples);
  for (std::size_t n = 450; n < 600; ++n) {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k <= 2 * kFilterReach * kFine; ++k) {
      const double away = (static_cast<double>(k) - static_cast<double>(kFilterReach * kFine)) / kFine;
      const double turn = 0.9 * std::numbers::pi * away;
      const double weight =
          (away == 0 ? 1 : std::sin(turn) / turn) * std::pow(std::cos(0.5 * std::numbers::pi * away / kFilterReach), 2);
      sum += weight * fine(static_cast<double>(n) + away);
      weights += weight;
    }
    x[n] = sum / weights;
  }
  test::add_noise(x, 2e-4 * peak_N, seed);
  return x;
}

std::vector<Hit> hits_of(const std::vector<std::vector<double>>& rows) {
  return find_hits(test::force_record(kFs_Hz, rows));
}

TEST(FlatTop, HasTheFlatnessOfClosedForms) {
  // sin²: the length above a fraction y of the peak is 1 − 2 asin(√y)/π.
  const double exact =
      (1 - 2 * std::asin(std::sqrt(0.8)) / std::numbers::pi) / (1 - 2 * std::asin(std::sqrt(0.3)) / std::numbers::pi);
  for (const double width : {8.0, 13.0, 40.0}) {
    const Hit hit = hits_of({cut_row(width, 1, 300, 1), cut_row(width, 1, 280, 2)}).front();
    EXPECT_NEAR(top_flatness(hit), exact, 0.02) << width;  // the filter rounds the pulse
    EXPECT_TRUE(hit.findings.empty()) << width;
  }
}

TEST(FlatTop, IsFoundInEachHitThatWasClippedBeforeTheFilter) {
  for (const double level : {0.8, 0.6}) {
    const std::vector<Hit> hits = hits_of({cut_row(7, 1, 300, 1), cut_row(8, level, 350, 2), cut_row(7.5, 1, 280, 3)});
    EXPECT_TRUE(hits[0].findings.empty());
    ASSERT_EQ(hits[1].findings.size(), 1U) << level;
    EXPECT_EQ(hits[1].findings[0].code, FindingCode::force_clipped);
    EXPECT_TRUE(hits[2].findings.empty());
  }
}

// A short haversine that is cut at 80 % of its peak is about as flat as half-sines behind a filter. It is flatter than
// the other hits.
TEST(FlatTop, IsFoundInAShortPulseUnlikeTheOthers) {
  const std::vector<Hit> hits =
      hits_of({cut_row(7, 1, 300, 1), cut_row(7.2, 1, 280, 2), cut_row(6.1, 0.8, 350, 3), cut_row(6.8, 1, 290, 4)});
  EXPECT_LT(top_flatness(hits[2]), 0.58);  // the limit for a short pulse alone
  for (std::size_t h = 0; h < hits.size(); ++h) EXPECT_EQ(hits[h].findings.size(), h == 2 ? 1U : 0U) << h;
}

// The filter's ripple makes half-sines of five samples as flat as 0.554.
TEST(FlatTop, IsNotFoundInHalfSinesThatTheFilterMadeFlat) {
  std::vector<std::vector<double>> rows;
  double flattest = 0;
  for (double width = 3; width < 12; width += 0.25) rows.push_back(cut_row(width, 1, 300, rows.size(), 1));
  for (const Hit& hit : hits_of(rows)) {
    flattest = std::max(flattest, top_flatness(hit));
    EXPECT_TRUE(hit.findings.empty()) << hit.onset_s;
  }
  EXPECT_GT(flattest, 0.54);  // the limit for longer pulses
}

// Without a filter, 5 samples do not determine the shape of a half-sine: the measured flatness is up to 0.57.
TEST(FlatTop, IsNotFoundInAShortPulseWithoutAnAntiAliasFilter) {
  std::vector<std::vector<double>> rows;
  for (const double onset : {500.0, 500.2, 500.4, 500.6, 500.8}) {
    std::vector<double>& row = rows.emplace_back(kSamples);
    for (std::size_t n = 500; n < 507; ++n) {
      const double phase = (static_cast<double>(n) - onset) / 5.12;
      if (phase > 0 && phase < 1) row[n] = 300 * std::sin(std::numbers::pi * phase);
    }
    test::add_noise(row, 0.01, 1);
  }
  for (const Hit& hit : hits_of(rows)) EXPECT_TRUE(hit.findings.empty()) << hit.onset_s;
}

}  // namespace percuss::acquire::flat_top_test
