#include "report/text/number_format.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percuss::report::number_format_test {

TEST(ValueWithStd, HasTwoDigitsOfTheStdAndAsManyDecimalsOfTheValue) {
  EXPECT_EQ(value_with_std(169.000341, 0.00042), "169.00034 ± 0.00042");
  EXPECT_EQ(value_with_std(1900, 0.15), "1900.00 ± 0.15");
  EXPECT_EQ(value_with_std(-3.14159, 0.012), "-3.142 ± 0.012");
  EXPECT_EQ(value_with_std(1.0002, 4e-4), "1.00020 ± 0.00040");
}

TEST(ValueWithStd, FollowsTheRoundedStd) {
  EXPECT_EQ(value_with_std(5, 0.0996), "5.00 ± 0.10");
  EXPECT_EQ(value_with_std(5, 0.00999), "5.000 ± 0.010");
  EXPECT_EQ(value_with_std(5, 0.0994), "5.000 ± 0.099");
}

TEST(ValueWithStd, HasNoDecimalsWhenTheStdIsLarge) {
  EXPECT_EQ(value_with_std(1234.4, 56), "1234 ± 56");
  EXPECT_EQ(value_with_std(1234.4, 560), "1234 ± 560");
}

TEST(ValueWithStd, WritesSmallDeviationsWithAnExponent) {
  EXPECT_EQ(value_with_std(1, 1e-11), "1.000000000000 ± 0.000000000010");
  EXPECT_EQ(value_with_std(1.5, 2.5e-13), "1.5 ± 2.5e-13");
  EXPECT_EQ(value_with_std(3e-15, 1e-17), "3e-15 ± 1.0e-17");
}

TEST(ValueWithStd, LeavesRoundingErrorsOut) { EXPECT_EQ(value_with_std(0.0102, 1.1e-17), "0.0102"); }

TEST(ValueWithStd, ShowsTheValueAloneWithoutAUsableStd) {
  EXPECT_EQ(value_with_std(169.0003412, 0), "169");
  EXPECT_EQ(value_with_std(169.1234567, -1), "169.123");
  EXPECT_EQ(value_with_std(2, std::numeric_limits<double>::quiet_NaN()), "2");
  EXPECT_EQ(value_with_std(2, std::numeric_limits<double>::infinity()), "2");
}

TEST(RoundedFrequencyText, UsesKilohertzFromAThousand) {
  EXPECT_EQ(rounded_frequency_text(999.4), "999.4 Hz");
  EXPECT_EQ(rounded_frequency_text(1000), "1 kHz");
  EXPECT_EQ(rounded_frequency_text(25600), "25.6 kHz");
  EXPECT_EQ(rounded_frequency_text(0.12345), "0.1235 Hz");
}

TEST(HertzText, HasNoExponentBelowAMegahertz) {
  EXPECT_EQ(hertz_text(67.0312), "67.03");
  EXPECT_EQ(hertz_text(3200), "3200");
  EXPECT_EQ(hertz_text(9999.6), "10000");
  EXPECT_EQ(hertz_text(12345.4), "12345");
  EXPECT_EQ(hertz_text(999999), "999999");
  EXPECT_EQ(hertz_text(2e6), "2e+06");
}

TEST(ForceText, HasThreeDigitsAndNoExponent) {
  EXPECT_EQ(force_text(232.4), "232 N");
  EXPECT_EQ(force_text(-1750.4), "-1750 N");
  EXPECT_EQ(force_text(999.6), "1000 N");
  EXPECT_EQ(force_text(12345), "12300 N");
  EXPECT_EQ(force_text(0.01234), "0.0123 N");
}

}  // namespace percuss::report::number_format_test
