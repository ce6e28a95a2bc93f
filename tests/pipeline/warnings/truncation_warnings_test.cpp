#include "pipeline/warnings/truncation_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::pipeline::truncation_warnings_test {

using testing::HasSubstr;

constexpr identify::Pole kPole{.freq_Hz = 100, .damping_ratio = 0.001};

acquire::LineRange lines() { return acquire::lines_from_frequencies({50, 51, 52, 53}, "test"); }

// Half of the mode's amplitude is left at the end.
TEST(TruncationWarnings, SayThatTheFitAllowsForTheMissingDecay) {
  const std::vector<Warning> warnings = truncation_warnings({{.pole = kPole}}, lines(), 0);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings.front().message, HasSubstr("the fit of the damping allows for the missing decay"));
}

// Where the pulse comes after the first sample, the fit without the force gives too high a damping, with any number of
// points and however small the ±.
TEST(TruncationWarnings, SayThatTheDampingOfGivenFrfsMayBeTooHigh) {
  const std::vector<Warning> warnings = frf_truncation_warnings({{.pole = kPole}}, lines(), 0, std::nullopt);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().severity, acquire::Severity::warn);
  EXPECT_THAT(warnings.front().message, HasSubstr("damping may be too high by as much where the records begin"));
}

// A window that is stated already is no cause of the damping.
TEST(TruncationWarnings, AskForTheWindowOfGivenFrfsUnlessItIsStated) {
  for (const double decay_per_s : {0.0, 0.5}) {
    const std::vector<Warning> warnings =
        frf_truncation_warnings({{.pole = kPole}}, lines(), decay_per_s, std::nullopt);
    ASSERT_EQ(warnings.size(), 1U);
    const bool asks = decay_per_s == 0;
    EXPECT_EQ(warnings.front().options.empty(), !asks);
    EXPECT_EQ(testing::Value(warnings.front().message, HasSubstr("exponential window")), asks);
  }
}

// The records last for 1 s. The ringing after the blow lasts for 0.9 s: exp(−0.2π · 0.9) = 56.8 % remain.
TEST(TruncationWarnings, SayWhenTheBlowOfGivenFrfsCame) {
  const std::vector<Warning> warnings = frf_truncation_warnings({{.pole = kPole}}, lines(), 0, 0.1);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().severity, acquire::Severity::warn);
  EXPECT_THAT(warnings.front().message, HasSubstr("100.0 Hz (56.8 %)"));
  EXPECT_THAT(warnings.front().message, HasSubstr("begin 0.1 s before the blow"));
}

}  // namespace percuss::pipeline::truncation_warnings_test
