#include "identify/fit/windowed_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::windowed_fit_test {

TEST(WindowedFit, SplitsAChainOfPolesAtItsWidestGap) {
  const FrfDataset set = test::empty_set(8192, 8192, 60, 3000, 1);
  WindowedFit all(set);
  // Each within four bandwidths of the next, the last two close together.
  all.replace({{500, 0.01}, {530, 0.01}, {560, 0.01}, {595, 0.01}, {596, 0.01}});
  ASSERT_EQ(all.groups().size(), 2U);
  EXPECT_EQ(all.groups()[0].fit.poles.size(), 3U);
  EXPECT_EQ(all.groups()[1].fit.poles.size(), 2U);
}

TEST(WindowedFit, WidensTheWindowOfABroadResonance) {
  FrfDataset set = test::empty_set(8192, 8192, 60, 3000, 1);
  test::add_mode(set, 0, {1000, 0.05}, 1);
  test::add_frf_noise(set, 0.3, 5);
  WindowedFit all(set);
  all.replace({{1003, 0.002}});
  all.sweep();
  all.widen();
  const FitGroup& group = all.groups().front();
  EXPECT_GE(group.count, 700U);  // nearly the largest window, 801 lines; the window of the first pole has 81
  EXPECT_LE(std::abs(group.fit.poles[0].freq_Hz - 1000), 5 * group.fit.freq_std_Hz(0));
}

}  // namespace percuss::identify::windowed_fit_test
