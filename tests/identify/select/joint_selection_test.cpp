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

}  // namespace percuss::identify::joint_selection_test
