#include "pipeline/findings/recorded_window.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::pipeline::recorded_window_test {

constexpr double kFs_Hz = 25600;
constexpr std::size_t kBlocks = 100;  // one second

// The noise of one response, which falls exponentially to `end` of its level before the hit.
NoiseHistory falling_to(double end) {
  NoiseHistory history{.after = {}, .before = 1};
  const double per_block = std::log(end) / static_cast<double>(kBlocks);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const double ripple = 0.01 * std::cos(static_cast<double>(b * b));  // the level of noise is known to about 1 %
    history.after.rms.push_back(std::exp(per_block * (static_cast<double>(b) + 0.5) + ripple));
  }
  return history;
}

TEST(RecordedWindow, IsFoundWithItsDecay) {
  for (const double end : {0.001, 0.05, 0.3, 0.6}) {
    const auto window = find_recorded_window({falling_to(end)}, 0, kFs_Hz);
    ASSERT_TRUE(window) << end;
    EXPECT_TRUE(window->exponential);
    const double duration_s = static_cast<double>(kBlocks * kDifferenceBlock) / kFs_Hz;
    EXPECT_NEAR(window->decay_per_s, -std::log(end) / duration_s, 5 * window->decay_std_per_s) << end;
    EXPECT_NEAR(window->end_level, end, 0.02) << end;  // end_level is the level at the middle of the last block
  }
}

// Noise of a quantiser that rounds towards zero falls by a few tenths while the response decays.
TEST(RecordedWindow, IsNotFoundWhereTheNoiseHardlyFalls) {
  for (const double end : {0.75, 0.85, 1.0, 1.1})
    EXPECT_FALSE(find_recorded_window({falling_to(end)}, 0, kFs_Hz)) << end;
}

}  // namespace percuss::pipeline::recorded_window_test
