#include "pipeline/warnings/hit_scatter_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
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

TEST(HitScatterWarnings, StateASlopeOfTheFrequencyWithTheDigitsOfItsStandardDeviation) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = 100, .damping_ratio = 0.01};
  mode.amplitude = identify::AmplitudeTrend{
      .freq_slope_Hz_per_N = -2e-3, .freq_slope_std = 8e-5, .freq_at_zero_Hz = 100.2, .freq_follows = true};
  EXPECT_THAT(hit_scatter_warnings({mode}).at(0).message,
              testing::HasSubstr("falls by 0.002000 ± 0.000080 Hz/N (softening; 100.2 Hz at zero force)"));
}

// Ten modes. The frequencies of the first `scattering` of them scatter between the hits.
std::vector<Warning> scatter_of(std::size_t scattering, double p_value) {
  std::vector<identify::Mode> modes(10);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].pole = {.freq_Hz = 100 + 50 * static_cast<double>(m), .damping_ratio = 0.01};
    modes[m].freq_std_parts_Hz.noise = 1e-3;
    if (m >= scattering) continue;
    modes[m].freq_std_parts_Hz.hits = 1e-2;
    modes[m].hit_scatter_Hz = 2e-2;
    modes[m].hit_scatter_freq_p = p_value;
  }
  return hit_scatter_warnings(modes);
}

// Ten modes have 20 values (frequencies and damping ratios). By chance, one of these reaches the limit for a single
// value, p = 1e-3, in one of 50 tests.
TEST(HitScatterWarnings, NameNoScatterThatChanceExplainsInSoManyValues) {
  EXPECT_TRUE(scatter_of(1, 1e-3).empty());
  EXPECT_EQ(scatter_of(1, 1e-5).at(0).code, "hits_differ");
  EXPECT_EQ(scatter_of(2, 1e-3).at(0).code, "hits_differ") << "two values at once are no chance";
}

TEST(HitScatterWarnings, NameTheModesThatTakeTheScatterOfTheOthers) {
  std::vector<identify::Mode> modes(3);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].pole = {.freq_Hz = 100 + 50 * static_cast<double>(m), .damping_ratio = 0.01};
    modes[m].freq_std_parts_Hz = {.noise = 1e-3, .hits = 1e-2, .misfit = 0};
    modes[m].hit_scatter_Hz = 2e-4 * modes[m].pole.freq_Hz;
    if (m < 2) modes[m].hit_scatter_freq_p = 1e-6;
  }
  const std::string others =
      "Modes too weak to show such a scatter are assumed to have it as well: 200 Hz (frequency by";
  EXPECT_THAT(hit_scatter_warnings(modes).at(0).message,
              testing::AllOf(testing::HasSubstr("explains it: 100 Hz (frequency by 200 ppm); 150 Hz (frequency by 200 "
                                                "ppm). Modes too weak"),
                             testing::HasSubstr(others)));
  for (std::size_t m = 0; m < 2; ++m) modes[m].drift = identify::DriftTrend{.freq_change_per_hit = -1e-5, .std = 1e-8};
  const std::vector<Warning> drifting = hit_scatter_warnings(modes);
  ASSERT_EQ(drifting.size(), 1U);
  EXPECT_THAT(drifting[0].message, testing::HasSubstr(others));
  modes[2].freq_std_parts_Hz.hits = 1e-4;
  EXPECT_THAT(hit_scatter_warnings(modes).at(0).message, testing::Not(testing::HasSubstr("too weak")))
      << "assumed scatter far below the noise is not mentioned";
}

std::string misfit_of(std::optional<double> residual_end_Hz) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = 743.2, .damping_ratio = 0.0168};
  mode.freq_std_parts_Hz = {.noise = 1e-3, .hits = 0, .misfit = 32e-3};
  EXPECT_GT(much_misfit(mode), 0);
  const Warning warning = hit_scatter_warnings({mode}, residual_end_Hz).at(0);
  EXPECT_EQ(warning.code, "model_misfit");
  return warning.message;
}

TEST(HitScatterWarnings, NameAModeBeyondTheLinesFirstWhereTheResidualGrowsTowardsTheirEnd) {
  EXPECT_THAT(misfit_of(975), testing::HasSubstr("grows towards the end of the fitted lines at 975 Hz"));
  EXPECT_THAT(misfit_of(975), testing::HasSubstr("; extend the band to above 975 Hz"));
  EXPECT_THAT(misfit_of(51.2), testing::HasSubstr("; extend the band to below 51.2 Hz"));
  EXPECT_THAT(misfit_of({}), testing::Not(testing::HasSubstr("grows")));
  EXPECT_THAT(misfit_of({}), testing::HasSubstr("a mode just beyond the band"));
  EXPECT_THAT(misfit_of({}), testing::HasSubstr("structure that the fitted modes do not explain"));
}

TEST(HitScatterWarnings, NameTheNoiseOfAnUnknownForce) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = 743.2, .damping_ratio = 0.0168};
  mode.freq_std_parts_Hz = {.noise = 1e-3, .hits = 0, .misfit = 32e-3};
  const std::string noise = "the noise of the force";
  EXPECT_THAT(hit_scatter_warnings({mode}, std::nullopt, false).at(0).message, testing::HasSubstr(noise));
  EXPECT_THAT(hit_scatter_warnings({mode}).at(0).message, testing::Not(testing::HasSubstr(noise)));
}

std::string drift_of(const std::vector<double>& change_per_hit) {
  std::vector<identify::Mode> modes(change_per_hit.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].pole = {.freq_Hz = 100 + 50 * static_cast<double>(m), .damping_ratio = 0.01};
    modes[m].drift = identify::DriftTrend{.freq_change_per_hit = change_per_hit[m], .std = 1e-8};
  }
  return hit_scatter_warnings(modes).at(0).message;
}

TEST(HitScatterWarnings, SayOnceThatAllModesDriftAlike) {
  EXPECT_THAT(drift_of({-5e-6, -5e-6}), testing::HasSubstr("all fall by 5.000 ± 0.010 ppm per hit. The values are "
                                                           "those of the middle of the test"));
  EXPECT_THAT(drift_of({5e-6, 6e-6}), testing::HasSubstr("150 Hz rises by 6.000 ± 0.010 ppm per hit"));
}

}  // namespace percuss::pipeline::hit_scatter_warnings_test
