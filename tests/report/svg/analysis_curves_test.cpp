#include "report/svg/analysis_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "acquire/record/record.hpp"

namespace percuss::report::analysis_curves_test {

// The response begins 40 samples after the peak of the force, so that the first blocks of the decay are constant. Its
// mean is exactly zero.
TEST(HitCurves, ShowADecayThatBeginsWithAConstantBlock) {
  constexpr std::size_t kSamples = 8192, kPeak = 510, kBegin = 550, kEnd = 6000;
  std::vector<double> force(kSamples), accel(kSamples);
  for (std::size_t i = 0; i <= 20; ++i)
    force[kPeak - 10 + i] = 300 * std::sin(std::numbers::pi * static_cast<double>(i) / 20);
  for (std::size_t i = kBegin; i < kEnd; i += 4) {
    const double amplitude = 100 * std::exp(-static_cast<double>(i - kBegin) / 500);
    accel[i] = accel[i + 1] = amplitude;
    accel[i + 2] = accel[i + 3] = -amplitude;
  }
  acquire::Record record = acquire::record_in_memory(12800, {force}, {{accel}});
  record.continuous = false;
  const pipeline::Analysis analysis(std::move(record), {});
  const std::vector<HitCurves> hits = hit_curves(analysis);
  ASSERT_EQ(hits.size(), 1U);
  const std::vector<double>& level = hits[0].decay_dB.value;
  ASSERT_GT(level.size(), 300U);
  EXPECT_TRUE(std::isnan(level[0])) << "a constant block has no level";
  // Blocks of 19 samples and the decay to 1/e in 500 samples: 8.7 dB in 26.3 blocks.
  EXPECT_EQ(*std::max_element(level.begin() + 3, level.begin() + 10), 0);
  EXPECT_NEAR(level[53] - level[27], -20 * std::log10(std::exp(26 * 19 / 500.0)), 0.1);
}

}  // namespace percuss::report::analysis_curves_test
