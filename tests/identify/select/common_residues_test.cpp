#include "identify/select/common_residues.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"

namespace percuss::identify::common_residues_test {

const std::vector<Pole> kPoles{{200, 0.01}, {203, 0.012}, {350, 0.005}};
const std::vector<Complex> kResidues{1.0, -0.6, {0.5, 0.05}};

FrfDataset measured() {
  FrfDataset set = test::empty_set(4096, 8192, 100, 500, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    for (std::size_t m = 0; m < kPoles.size(); ++m) test::add_mode(set, o, kPoles[m], kResidues[m]);
  }
  test::add_frf_noise(set, 1e-3, 1);
  return set;
}

// Modes as fitted in separate windows, with their residues multiplied by these factors.
std::vector<FittedMode> local_modes(const std::vector<double>& factor) {
  std::vector<FittedMode> modes;
  for (std::size_t m = 0; m < kPoles.size(); ++m) {
    FittedMode mode;
    mode.mode.pole = kPoles[m];
    for (std::size_t o = 0; o < 2; ++o)
      mode.mode.residues.push_back({.channel = o, .value = factor[m] * kResidues[m], .std = 1e-6});
    modes.push_back(mode);
  }
  return modes;
}

TEST(CommonResidues, ReplaceResiduesThatDoNotAddUp) {
  const FrfDataset set = measured();
  std::vector<FittedMode> modes = local_modes({1.8, 1.5, 1});
  modes[0].mode.residues[0].own_pole = Pole{199, 0.01};
  fit_common_residues(set, modes);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (const Residue& residue : modes[m].mode.residues) {
      EXPECT_FALSE(residue.own_pole);
      EXPECT_GT(residue.std, 1e-6);
      EXPECT_LE(std::abs(residue.value - kResidues[m]), 6 * residue.std) << m;  // by chance in 1 of 10^8
      EXPECT_LE(residue.std, 0.01) << m;
    }
  }
}

TEST(CommonResidues, LeaveResiduesThatAddUp) {
  const FrfDataset set = measured();
  std::vector<FittedMode> modes = local_modes({1.001, 1, 0.999});
  fit_common_residues(set, modes);
  EXPECT_EQ(modes[0].mode.residues[0].value, 1.001 * kResidues[0]);
  EXPECT_EQ(modes[2].mode.residues[1].std, 1e-6);
}

TEST(CommonResidues, LeaveModesOfAJointFit) {
  const FrfDataset set = measured();
  std::vector<FittedMode> modes = local_modes({1.8, 1.5, 1});
  for (FittedMode& mode : modes) mode.joint = true;
  fit_common_residues(set, modes);
  EXPECT_EQ(modes[0].mode.residues[0].value, 1.8 * kResidues[0]);
}

}  // namespace percuss::identify::common_residues_test
