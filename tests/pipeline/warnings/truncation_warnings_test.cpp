#include "pipeline/warnings/truncation_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::pipeline::truncation_warnings_test {

// Half of the mode's amplitude is left at the end. Where the pulse comes after the first sample, the fit without the
// force gives too high a damping, with any number of points and however small the ±.
TEST(TruncationWarnings, SayThatTheDampingOfGivenFrfsMayBeTooHigh) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = 100, .damping_ratio = 0.001};
  const acquire::LineRange lines = acquire::lines_from_frequencies({50, 51, 52, 53}, "test");
  const std::vector<Warning> unknown = truncation_warnings({mode}, lines, 0, false, std::nullopt);
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_THAT(unknown.front().message,
              testing::HasSubstr("damping may be too high by as much where the records begin"));
  const std::vector<Warning> known = truncation_warnings({mode}, lines, 0, true, std::nullopt);
  ASSERT_EQ(known.size(), 1U);
  EXPECT_THAT(known.front().message, testing::HasSubstr("the fit of the damping allows for the missing decay"));
}

}  // namespace percuss::pipeline::truncation_warnings_test
