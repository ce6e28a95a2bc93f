#include "identify/select/crowded_fit.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::crowded_fit_test {

// 20 modes with bandwidths of 30 Hz, 55 to 70 Hz apart, at two FRFs.
std::vector<Pole> overlapping_modes() {
  std::vector<Pole> poles;
  double freq_Hz = 180;
  for (int m = 0; m < 20; ++m) {
    poles.push_back({.freq_Hz = freq_Hz, .damping_ratio = 15 / freq_Hz});
    freq_Hz += 55 + 15 * (m % 2);
  }
  return poles;
}

FrfDataset set_of(const std::vector<Pole>& poles) {
  FrfDataset set = test::empty_set(8192, 8192, 40, 1600, 2);
  for (std::size_t m = 0; m < poles.size(); ++m) {
    test::add_mode(set, 0, poles[m], 0.6 + 0.2 * static_cast<double>(m % 3));
    test::add_mode(set, 1, poles[m], m % 2 == 0 ? 0.5 : -0.4);
  }
  test::add_frf_noise(set, 1e-3, 3);
  return set;
}

TEST(CrowdedFit, FindsTwentyModesWhoseBandwidthsAreHalfTheirSpacing) {
  const std::vector<Pole> truth = overlapping_modes();
  const std::vector<Mode> found = identify_modes(set_of(truth));
  test::expect_modes_near(found, truth);
  ASSERT_EQ(found.size(), truth.size());
  for (std::size_t m = 0; m < truth.size(); ++m) EXPECT_LT(found[m].freq_std_Hz, 0.2 * truth[m].half_power_Hz()) << m;
}

TEST(CrowdedFit, IsForManyModesThatOverlap) {
  const std::vector<Pole> all = overlapping_modes();
  EXPECT_TRUE(are_crowded(all, 1560));
  EXPECT_NEAR(overlap_of(all, 1560), 20 * 30 / 1560.0, 1e-9);
  EXPECT_FALSE(are_crowded({all.begin(), all.begin() + 10}, 1560));
  std::vector<Pole> sharp = all;
  for (Pole& pole : sharp) pole.damping_ratio /= 10;
  EXPECT_FALSE(are_crowded(sharp, 1560));
}

// Rounding errors, a misfit or coarse quantisation give many stable poles, too. Almost none of them shows as a peak, or
// their bandwidths cover more than the band.
TEST(CrowdedFit, IsNotForStablePolesThatShowNoPeaks) {
  std::vector<Pole> wide = overlapping_modes();
  for (Pole& pole : wide) pole.damping_ratio *= 3;
  const FrfDataset set = set_of(overlapping_modes());
  EXPECT_FALSE(crowded_fit(set, overlapping_modes(), {overlapping_modes()[3], overlapping_modes()[8]}));
  EXPECT_FALSE(crowded_fit(set, wide, overlapping_modes()));
  EXPECT_TRUE(crowded_fit(set, overlapping_modes(), overlapping_modes()));
}

TEST(CrowdedFit, IsEmptyWhereItsModesDoNotOverlap) {
  const std::vector<Pole> all = overlapping_modes(), few{all[2], all[7], all[12]};
  EXPECT_FALSE(crowded_fit(set_of(few), all, all));
}

}  // namespace percuss::identify::crowded_fit_test
