#include "pipeline/warnings/hit_scatter_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace percuss::pipeline::hit_scatter_warnings_test {

// The warning about one mode of 1 % damping, whose damping changes by this part of itself per newton.
std::string nonlinear(double change_per_N, double std_per_N) {
  constexpr double kDamping = 0.01;
  identify::Mode mode;
  mode.pole = {.freq_Hz = 100, .damping_ratio = kDamping};
  mode.amplitude = identify::AmplitudeTrend{.damping_slope_per_N = kDamping * change_per_N,
                                            .damping_slope_std = kDamping * std_per_N,
                                            .damping_follows = true};
  const std::vector<Warning> warnings = hit_scatter_warnings({mode});
  return warnings.empty() ? "" : warnings.front().message;
}

TEST(HitScatterWarnings, StateASlopeOfTheDampingPerHundredNewtons) {
  EXPECT_THAT(nonlinear(-0.0038, 0.0004),
              testing::HasSubstr("damping falls by 38 ± 4 % of itself per 100 N (as dry friction does)"));
}

TEST(HitScatterWarnings, StateASteepSlopePerSmallerForceSoThatNothingFallsByMoreThanAllOfIt) {
  EXPECT_THAT(nonlinear(-0.0158, 0.0004), testing::HasSubstr("damping falls by 15.8 ± 0.4 % of itself per 10 N"));
  EXPECT_THAT(nonlinear(0.158, 0.01), testing::HasSubstr("damping rises by 16 ± 1 % of itself per 1 N"));
}

}  // namespace percuss::pipeline::hit_scatter_warnings_test
