#include "report/html/fit_plot_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace percuss::report::fit_plot_data_test {

const acquire::LineRange kBand{.fs_Hz = 20000, .samples = 20000, .first = 100, .count = 5000};

TEST(DrawnLines, AreAllOfAShortBand) { EXPECT_EQ(drawn_lines(kBand, {}, {}, 5000).size(), 5000U); }

TEST(DrawnLines, LieDenseAroundModes) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = 1000, .damping_ratio = 0.005};  // 10 Hz, ten lines, between the half-power points
  const auto lines = drawn_lines(kBand, {mode}, {}, 400);
  EXPECT_LE(lines.size(), 400U);
  EXPECT_GE(lines.size(), 200U);
  EXPECT_EQ(lines.front(), 0U);
  EXPECT_EQ(lines.back(), 4999U);
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end()));
  for (std::size_t k = 895; k <= 905; ++k)
    EXPECT_TRUE(std::binary_search(lines.begin(), lines.end(), k)) << "every line between the half-power points: " << k;
  std::size_t widest = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) widest = std::max(widest, lines[i] - lines[i - 1]);
  EXPECT_LE(widest, 40U) << "evenly elsewhere";
}

}  // namespace percuss::report::fit_plot_data_test
