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

// The misfit of a strong mode, here an unknown partner, raises the residual at a weak mode beside it.
TEST(ClearModes, IncludeOneBesideAMisfitThatRaisesTheLikelihoodMuch) {
  const Pole strong{.freq_Hz = 1000, .damping_ratio = 0.005}, partner{.freq_Hz = 1004, .damping_ratio = 0.006};
  const Pole weak{.freq_Hz = 1060, .damping_ratio = 0.005};
  FrfDataset set = test::empty_set(8192, 32768, 800, 1300, 4);
  for (std::size_t o = 0; o < 4; ++o) {
    const auto x = static_cast<double>(o);
    test::add_mode(set, o, strong, 1 - 0.2 * x);
    test::add_mode(set, o, partner, 0.1 + 0.1 * x);
    test::add_mode(set, o, weak, 0.04 + 0.02 * x);
  }
  test::add_frf_noise(set, 1e-3, 3);
  const JointFit before = fit_residues(set, {strong}), after = fit_residues(set, {strong, weak});
  const double peak = significance_of(set, after, 1, Misfit::counted).peak_to_residual;
  ASSERT_GT(peak, 5);
  ASSERT_LT(peak, 10);
  const std::vector<Pole> clear = clear_modes(set, {before.poles, before.residual}, after);
  ASSERT_EQ(clear.size(), 1U);
  EXPECT_EQ(clear[0], weak);
}

}  // namespace percuss::identify::joint_selection_test
