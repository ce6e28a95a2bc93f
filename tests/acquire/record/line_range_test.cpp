#include "acquire/record/line_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::acquire::line_range_test {

TEST(LinesFromFrequencies, FindsSpacingAndFirstLine) {
  const LineRange lines = lines_from_frequencies({60, 60.5, 61}, "x");
  EXPECT_EQ(lines.first, 120U);
  EXPECT_EQ(lines.count, 3U);
  EXPECT_EQ(lines.df_Hz(), 0.5);
  EXPECT_EQ(lines.freq_Hz(2), 61.0);
}

TEST(LinesFromFrequencies, AllowsFrequenciesThatWereRounded) {
  std::vector<double> freq_Hz(1000);
  for (std::size_t k = 0; k < freq_Hz.size(); ++k)
    freq_Hz[k] = std::round(0.1953125 * static_cast<double>(k) * 100) / 100;
  EXPECT_LE(std::abs(lines_from_frequencies(freq_Hz, "x").df_Hz() / 0.1953125 - 1), 1e-4)
      << "the last frequency, 195 Hz, is rounded to 0.01 Hz";
}

}  // namespace percuss::acquire::line_range_test
