#include "identify/select/joint_selection.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"

namespace percuss::identify::joint_selection_test {

// The FRFs of these modes, as a residual.
std::vector<Eigen::VectorXcd> residual_of(const std::vector<Pole>& poles, FrfDataset set) {
  for (const Pole& pole : poles) test::add_mode(set, 0, pole, 1);
  test::add_frf_noise(set, 1e-4, 5);
  return test::frf_vectors(set);
}

TEST(Misfit, IsRemovedForATailAndStaysForAMissingMode) {
  const FrfDataset empty = test::empty_set(8192, 8192, 40, 1500, 1);
  const Pole mode{.freq_Hz = 1000, .damping_ratio = 0.002}, beyond{.freq_Hz = 1550, .damping_ratio = 0.002};
  const Pole beside{.freq_Hz = 1003, .damping_ratio = 0.002};
  FrfDataset set = empty;
  test::add_mode(set, 0, mode, 1);
  const auto tail = residual_of({beyond}, empty), missing = residual_of({beside}, empty);
  EXPECT_GT(misfit_of(set, tail, mode), kMinMisfit);
  EXPECT_LT(misfit_of(set, tail, mode, Tails::removed), kMinMisfit);
  EXPECT_GT(misfit_of(set, missing, mode, Tails::removed), kMinMisfit);
  EXPECT_TRUE(is_material(set, tail, mode));
  EXPECT_FALSE(is_material(set, tail, mode, Tails::removed));
  EXPECT_TRUE(is_material(set, missing, mode, Tails::removed));
}

// The clear modes of a strong mode and a weak one, where only the strong one is known. The peak of the weak one is five
// to ten times the residual around it, which holds noise and, if `misfit` is not 0, an unknown partner of the strong
// one.
std::vector<Pole> clear_beside_strong(double weak_Hz, double size, double misfit, double noise) {
  const Pole strong{.freq_Hz = 1000, .damping_ratio = 0.005}, partner{.freq_Hz = 1004, .damping_ratio = 0.006};
  const Pole weak{.freq_Hz = weak_Hz, .damping_ratio = 0.005};
  FrfDataset set = test::empty_set(8192, 32768, 800, 1300, 4);
  for (std::size_t o = 0; o < 4; ++o) {
    const auto x = static_cast<double>(o);
    test::add_mode(set, o, strong, 1 - 0.2 * x);
    test::add_mode(set, o, partner, misfit * (1 + x));
    test::add_mode(set, o, weak, size * (1 + 0.5 * x));
  }
  test::add_frf_noise(set, noise, 3);
  const JointFit before = fit_residues(set, {strong}), after = fit_residues(set, {strong, weak});
  const ModeSignificance of_weak = significance_of(set, after, 1, Misfit::counted);
  EXPECT_GT(of_weak.significance, 2 * kJointSignificance);
  EXPECT_GT(of_weak.peak_to_residual, 5);
  EXPECT_LT(of_weak.peak_to_residual, 10);
  return clear_modes(set, {before.poles, before.residual}, after);
}

TEST(ClearModes, IncludeAPeakBelow20DecibelsIfItRaisesTheLikelihoodMuch) {
  const std::vector<Pole> clear = clear_beside_strong(1120, 0.04, 0, 0.8);
  ASSERT_EQ(clear.size(), 1U);
  EXPECT_EQ(clear[0].freq_Hz, 1120);
}

TEST(ClearModes, LeaveOutAPeakBelow20DecibelsThatGainsLittleBesideAMisfit) {
  EXPECT_TRUE(clear_beside_strong(1040, 0.01, 0.01, 1e-3).empty());
}

}  // namespace percuss::identify::joint_selection_test
