#include "acquire/record/frequency_lines.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::frequency_lines_test {

using test::input_error_of;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kDoubles = 1e-14;  // relative; product and quotient of two doubles

// The multiples first … first + count − 1 of a spacing, as a format of fmt writes them.
std::vector<double> written(double spacing, std::size_t first, std::size_t count, const char* format) {
  std::vector<double> out;
  for (std::size_t k = 0; k < count; ++k)
    out.push_back(std::stod(fmt::format(fmt::runtime(format), static_cast<double>(first + k) * spacing)));
  return out;
}

double error_of(double df_Hz, std::size_t first, std::size_t count, const char* format) {
  const FrequencyLines found = frequency_lines(written(df_Hz, first, count, format), 1, "x");
  EXPECT_EQ(found.lines.first, first);
  EXPECT_EQ(found.lines.count, count);
  EXPECT_LE(found.spacing.lowest_Hz, df_Hz);
  EXPECT_GE(found.spacing.highest_Hz, df_Hz);
  return std::abs(found.lines.df_Hz() / df_Hz - 1);
}

// In the first three cases, the last frequency divided by its number is 0.7812506, 0.7812501 and 1.25006 Hz.
TEST(FrequencyLines, FindsARoundSpacingOfRoundedFrequencies) {
  EXPECT_LE(error_of(0.78125, 0, 2048, "{:.2f}"), kDoubles);
  EXPECT_LE(error_of(0.78125, 0, 2048, "{:.3f}"), kDoubles);
  EXPECT_LE(error_of(1.25, 0, 800, "{:.1f}"), kDoubles);
  EXPECT_LE(error_of(0.78125, 64, 2048, "{:.2f}"), kDoubles);
  EXPECT_LE(error_of(1.5625, 64, 6001, "{:.5g}"), kDoubles);
  EXPECT_LE(error_of(0.390625, 0, 4096, "{:.6g}"), kDoubles);
}

// These spacings have many digits. The record's length (3 s), the last frequency (1600 Hz) and the sampling rate
// (44100 Hz = 65536 spacings) have few.
TEST(FrequencyLines, FindsASpacingThatIsRoundInAnotherForm) {
  EXPECT_LE(error_of(1.0 / 3, 0, 2000, "{:.3f}"), kDoubles);
  EXPECT_LE(error_of(1600.0 / 2047, 0, 2048, "{:.3f}"), kDoubles);
  EXPECT_LE(error_of(44100.0 / 65536, 0, 6401, "{:.2f}"), kDoubles);
}

TEST(FrequencyLines, FindsTheSpacingOfFrequenciesInSinglePrecision) {
  std::vector<double> numbers;
  for (int k = 0; k < 5000; ++k) numbers.push_back(static_cast<double>(static_cast<float>(0.1 * k)));
  EXPECT_LE(std::abs(frequency_lines(numbers, 1, "x").lines.df_Hz() / 0.1 - 1), kDoubles);
}

TEST(FrequencyLines, FindsARoundSpacingInHzOrInTheUnitOfTheFile) {
  const auto spacing_Hz = [](double unit_spacing, double to_Hz) {
    return frequency_lines(written(unit_spacing, 0, 1500, "{:.2f}"), to_Hz, "x").lines.df_Hz();
  };
  EXPECT_NEAR(spacing_Hz(0.5 * kTwoPi, 1 / kTwoPi), 0.5, 0.5 * kDoubles);
  EXPECT_NEAR(spacing_Hz(0.125, 1 / 60.0), 0.125 / 60, 0.002 * kDoubles);
}

// The roundest spacing within the limits is 0.618034 Hz. It has as many digits as limits around a random number need,
// so it is not taken for the true one.
TEST(FrequencyLines, TakesTheMiddleOfTheLimitsWithoutARoundSpacing) {
  constexpr double kSpacing_Hz = 0.61803398875;
  const FrequencyLines found = frequency_lines(written(kSpacing_Hz, 0, 300, "{:.2f}"), 1, "x");
  EXPECT_LE(std::abs(found.lines.df_Hz() - (found.spacing.lowest_Hz + found.spacing.highest_Hz) / 2), kDoubles);
  EXPECT_LE(std::abs(found.lines.df_Hz() - kSpacing_Hz), found.spacing.highest_Hz - found.spacing.lowest_Hz);
  EXPECT_THAT(found.note, HasSubstr("lies between"));
}

TEST(FrequencyLines, NotesARoundedSpacing) {
  EXPECT_THAT(frequency_lines(written(1.25, 0, 800, "{:.1f}"), 1, "x").note,
              HasSubstr("spacing is taken as 1.25 Hz, not 1.250062578"));
  EXPECT_THAT(frequency_lines(written(0.3125, 0, 4097, "{:.2f}"), 1, "x").note, IsEmpty());
}

// The spacing of such frequencies is the last frequency divided by its number, to the last bit.
TEST(FrequencyLines, KeepsFrequenciesThatAreNotRounded) {
  for (const double df_Hz : {0.5, 1.0 / 3, 0.61803398875, 3.0}) {
    std::vector<double> numbers;
    for (int k = 0; k < 1000; ++k) numbers.push_back((20 + k) * df_Hz);
    const FrequencyLines found = frequency_lines(numbers, 1, "x");
    EXPECT_EQ(found.lines.fs_Hz, numbers.back() / 1019 * (2 * 1019)) << df_Hz;
    EXPECT_THAT(found.note, IsEmpty());
  }
}

TEST(FrequencyLines, AcceptsSmallOffsetsThatNoRoundingExplains) {
  std::vector<double> numbers = written(1, 0, 100, "{:.9f}");
  numbers[40] += 0.04;
  EXPECT_EQ(frequency_lines(numbers, 1, "x").lines.df_Hz(), 1);
  numbers[40] += 0.02;
  EXPECT_THAT(input_error_of([&] { frequency_lines(numbers, 1, "x"); }), HasSubstr("40.06 Hz is not a multiple"));
}

TEST(FrequencyLines, RefusesAMissingLineAmongRoundedFrequencies) {
  for (const std::size_t lost : {1U, 400U, 798U}) {
    auto numbers = written(1.25, 0, 800, "{:.1f}");
    numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(lost));
    EXPECT_THAT(input_error_of([&] { frequency_lines(numbers, 1, "x"); }), HasSubstr("not a multiple")) << lost;
  }
}

// Lines between the multiples of their spacing, as a zoom measurement has them.
TEST(FrequencyLines, RefusesLinesBetweenMultiples) {
  auto numbers = written(1.25, 0, 800, "{:.2f}");
  for (double& number : numbers) number += 100.4;
  EXPECT_THAT(input_error_of([&] { frequency_lines(numbers, 1, "x"); }), HasSubstr("not a multiple"));
}

// Multiples of such numbers may be infinite; the conversion of the exponent of infinity to int would be undefined.
TEST(FrequencyLines, AcceptsNumbersAtTheLimitsOfDoubles) {
  for (const double unit : {1e307, 1e-307}) {
    EXPECT_EQ(frequency_lines({0, 1.01 * unit, 2 * unit}, 1, "x").lines.df_Hz(), unit);
    EXPECT_EQ(frequency_lines({0, unit, 2 * unit}, 1, "x").lines.df_Hz(), unit);
  }
}

TEST(FrequencyLines, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(input_error_of([&] { frequency_lines({0, bad, 2}, 1, "x"); }), HasSubstr("not a multiple"));
    EXPECT_NE(input_error_of([&] { frequency_lines({0, 1, bad}, 1, "x"); }), "");
    EXPECT_NE(input_error_of([&] { frequency_lines({bad, 1, 2}, 1, "x"); }), "");
  }
}

}  // namespace percuss::acquire::frequency_lines_test
