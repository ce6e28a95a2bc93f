#include "report/svg/deflection_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::report::deflection_chart_test {

constexpr double kFs_Hz = 1000;
constexpr std::size_t kSamples = 2000;

// An oscillation of 2.6 mm about a drift to 1800 mm, whose ± is a third of the drift.
pipeline::DeflectedHit drifting_hit(std::size_t number) {
  pipeline::DeflectedHit hit{.hit = number, .channel = 0, .point = 0, .deflection = {}};
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double t_s = static_cast<double>(i) / kFs_Hz;
    const double drift_m = 1.8 * std::pow(t_s / 2, 3);
    hit.deflection.deflection_m.push_back(2.6e-3 * std::sin(2 * M_PI * 38 * t_s) - drift_m);
    hit.deflection.std_m.push_back(drift_m / 3);
  }
  hit.deflection.peak = 7;
  hit.deflection.peak_m = 2.6e-3;
  return hit;
}

LineChart chart_of(std::vector<pipeline::DeflectedHit> hits) {
  acquire::Record record =
      acquire::record_in_memory(kFs_Hz, {std::vector<double>(kSamples, 0.0)}, {{std::vector<double>(kSamples, 0.0)}});
  const pipeline::Analysis analysis(std::move(record), {});
  pipeline::ImpactTest test;
  test.hits = std::move(hits);
  test.points = {{.point = 0, .channel = 0, .hits = test.hits.size(), .peak_m = 2.6e-3}};
  return deflection_chart(analysis, test);
}

TEST(DeflectionChart, EndsWhereTheDeflectionIsNotDetermined) {
  const pipeline::DeflectedHit hit = drifting_hit(0);
  const LineChart chart = chart_of({hit});
  EXPECT_EQ(chart.title, "Deflection at the accelerometer, until its ± exceeds half the peak");
  const ChartCurve& curve = chart.curves.at(0);
  const std::size_t drawn = curve.y.size();
  ASSERT_LT(drawn, kSamples);
  EXPECT_LE(hit.deflection.std_m[drawn - 1], 1.3e-3);
  EXPECT_GT(hit.deflection.std_m[drawn], 1.3e-3) << "not earlier than needed";
  EXPECT_GT(*std::min_element(curve.y.begin(), curve.y.end()), -10) << "mm: 1800 mm would hide 2.6 mm";
  ASSERT_EQ(chart.bands.size(), 1U);
  EXPECT_EQ(chart.bands[0].x, curve.x);
  EXPECT_DOUBLE_EQ(chart.bands[0].high.back() - chart.bands[0].low.back(), 2000 * hit.deflection.std_m[drawn - 1]);
}

TEST(DeflectionChart, DrawsDeterminedDeflectionsWhole) {
  pipeline::DeflectedHit hit = drifting_hit(0);
  for (double& std_m : hit.deflection.std_m) std_m = 1e-6;
  const LineChart known = chart_of({hit});
  EXPECT_EQ(known.title, "Deflection at the accelerometer");
  EXPECT_EQ(known.curves.at(0).y.size(), kSamples);
  hit.deflection.std_m.clear();
  const LineChart unknown = chart_of({hit});
  EXPECT_EQ(unknown.curves.at(0).y.size(), kSamples);
  EXPECT_TRUE(unknown.bands.empty());
}

// Its drift must not set the scale of the others.
TEST(DeflectionChart, EndsAHitWithoutAPeakLikeTheOthers) {
  pipeline::DeflectedHit weak = drifting_hit(1);
  weak.deflection.peak_m = std::numeric_limits<double>::quiet_NaN();
  const LineChart chart = chart_of({drifting_hit(0), weak});
  ASSERT_EQ(chart.curves.size(), 2U);
  EXPECT_EQ(chart.curves[1].y.size(), chart.curves[0].y.size());
  EXPECT_EQ(chart_of({weak}).curves.at(0).y.size(), kSamples) << "no peak sets a limit";
}

}  // namespace percuss::report::deflection_chart_test
