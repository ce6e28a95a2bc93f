#include "identify/select/residual_mode_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/select/sequential_fit.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::residual_mode_search_test {

const Pole kNarrow{400, 0.01}, kBroad{1100, 0.29};

FrfDataset narrow_and_broad(std::uint64_t seed) {
  FrfDataset set = test::empty_set(8192, 8192, 0, 3400, 2);
  test::add_mode(set, 0, kNarrow, 1);
  test::add_mode(set, 1, kNarrow, 0.5);
  test::add_mode(set, 0, kBroad, 0.6);
  test::add_mode(set, 1, kBroad, -0.8);
  test::add_frf_noise(set, 0.003, seed);
  return set;
}

TEST(ResidualModeSearch, RetriesTheMostSignificantBroadModeAlone) {
  const FrfDataset set = narrow_and_broad(1);
  WindowedFit all(set);
  all.replace({kNarrow});
  all.sweep();
  ResidualModeSearch search;
  EXPECT_FALSE(search.has_tried_any());
  const auto spurious = search.next(all, ResidualSearch::all);
  EXPECT_FALSE(spurious.empty());
  EXPECT_TRUE(search.has_tried_any());
  EXPECT_EQ(search.next(all, ResidualSearch::all).size(), 1U) << "the most significant of the rejected modes";
}

TEST(ResidualModeSearch, FindsNothingInAResidualOfNoise) {
  const FrfDataset set = narrow_and_broad(2);
  WindowedFit all(set);
  all.replace({kNarrow, kBroad});
  all.sweep();
  EXPECT_TRUE(ResidualModeSearch().next(all, ResidualSearch::all).empty());
}

TEST(FitSequentially, FindsAModeTooBroadForAPeak) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const FrfDataset set = narrow_and_broad(seed);
    const auto modes = fit_sequentially(set);
    ASSERT_EQ(modes.size(), 2U) << seed;
    EXPECT_LE(std::abs(modes[1].mode.pole.freq_Hz - kBroad.freq_Hz), 5 * modes[1].mode.freq_std_Hz) << seed;
  }
}

}  // namespace percuss::identify::residual_mode_search_test
