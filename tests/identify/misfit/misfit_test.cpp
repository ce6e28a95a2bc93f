#include "identify/misfit/misfit.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/modal_frfs.hpp"

namespace percuss::identify::misfit_test {

Mode mode_with(const Pole& pole, Complex residue) {
  Mode mode{.pole = pole, .freq_std_Hz = 1e-3, .damping_std = 1e-6};
  mode.residues.push_back({.point = 0, .channel = 0, .value = residue});
  return mode;
}

// A mode at 573 Hz below the flank of a mode at 1104 Hz; the lines end at 900 Hz. A joint fit describes the flank by a
// broad mode beyond the lines together with its residual terms. The residue of the broad mode is large, and the
// residual terms cancel most of its contribution.
TEST(AddMisfit, SubtractsNoModeBeyondTheLines) {
  const Pole inside{.freq_Hz = 573, .damping_ratio = 0.028};
  FrfDataset set = test::empty_set(8192, 8192, 100, 900, 1);
  test::add_mode(set, 0, inside, 1);
  test::add_mode(set, 0, {.freq_Hz = 1104, .damping_ratio = 0.03}, 1);
  test::add_frf_noise(set, 0.01, 3);
  const std::vector<Mode> alone = with_misfit(set, {mode_with(inside, 1)});
  const Mode beyond = mode_with({.freq_Hz = 1000, .damping_ratio = 0.2}, 30);
  const std::vector<Mode> both = with_misfit(set, {mode_with(inside, 1), beyond});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_GT(alone[0].freq_std_Hz, 1e-3);  // the polynomial does not follow all of the flank
  EXPECT_EQ(both[0].freq_std_Hz, alone[0].freq_std_Hz);
  EXPECT_EQ(both[0].damping_std, alone[0].damping_std);
  EXPECT_EQ(both[1].freq_std_Hz, beyond.freq_std_Hz);
}

}  // namespace percuss::identify::misfit_test
