#include "identify/select/crowded_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "identify/identify.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::crowded_fit_test {

constexpr double kDeviations = 4.5;  // standard deviations; a normal error exceeds them once in 150 000

// 20 modes with bandwidths of 30 Hz, 55 to 70 Hz apart, at two FRFs.
std::vector<Pole> crowd() {
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

void expect_found(const std::vector<Mode>& found, const std::vector<Pole>& truth) {
  ASSERT_EQ(found.size(), truth.size());
  for (std::size_t m = 0; m < truth.size(); ++m) {
    EXPECT_LE(std::abs(found[m].pole.freq_Hz - truth[m].freq_Hz), kDeviations * found[m].freq_std_Hz) << m;
    EXPECT_LE(std::abs(found[m].pole.damping_ratio - truth[m].damping_ratio), kDeviations * found[m].damping_std) << m;
    EXPECT_LT(found[m].freq_std_Hz, 0.2 * truth[m].half_power_Hz()) << m;
  }
}

TEST(CrowdedFit, FindsTwentyModesThatOverlapByAHalf) { expect_found(identify_modes(set_of(crowd())), crowd()); }

TEST(CrowdedFit, IsForManyModesThatOverlap) {
  const std::vector<Pole> all = crowd();
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
  std::vector<Pole> wide = crowd();
  for (Pole& pole : wide) pole.damping_ratio *= 3;
  const FrfDataset set = set_of(crowd());
  EXPECT_FALSE(crowded_fit(set, crowd(), {crowd()[3], crowd()[8]}));
  EXPECT_FALSE(crowded_fit(set, wide, crowd()));
  EXPECT_TRUE(crowded_fit(set, crowd(), crowd()));
}

TEST(CrowdedFit, IsNothingWhereItsModesAreNoCrowd) {
  const std::vector<Pole> all = crowd(), few{all[2], all[7], all[12]};
  EXPECT_FALSE(crowded_fit(set_of(few), all, all));
}

}  // namespace percuss::identify::crowded_fit_test
