#include "identify/start/truncation_ripples.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::truncation_ripples_test {

// One mode that does not decay within the record of one second, and one with the same residues that does, whose peak is
// lower.
FrfDataset truncated_set() {
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 400.3, .damping_ratio = 1e-5, .residue_per_kg = {1, 0.5}},
                                          {.freq_Hz = 900, .damping_ratio = 0.005, .residue_per_kg = {1, 0.5}}},
                                         1);
  spec.points = {{}};
  return test::frf_set_of(synth::synthesise(spec, 1).record, 60, 2400);
}

TEST(TruncationRipples, AreSuspectedBelowTheFlankOfATruncatedDecay) {
  const FrfDataset set = truncated_set();
  const std::vector<Pole> poles{{400.3, 1e-5}, {430, 1e-4}, {900, 0.005}};
  const auto doubtful = find_truncation_ripples(set, poles);
  EXPECT_FALSE(doubtful[0]) << "the mode itself";
  EXPECT_TRUE(doubtful[1]) << "on its flank";
  EXPECT_FALSE(doubtful[2]) << "a peak above it";
}

TEST(TruncationRipples, AreAbsentWhereAllPolesDecay) {
  const auto doubtful = find_truncation_ripples(truncated_set(), {{430, 0.01}, {900, 0.005}});
  EXPECT_FALSE(doubtful[0]);
  EXPECT_FALSE(doubtful[1]);
}

TEST(TruncationRipples, RemainOnlyWithEnergyInTheResidual) {
  const FrfDataset set = truncated_set();
  std::vector<Eigen::VectorXcd> residual = test::frf_vectors(set);
  EXPECT_TRUE(remains_in_residual(set, {900, 0.005}, residual));
  for (Eigen::VectorXcd& left : residual) left *= 0.1;
  EXPECT_FALSE(remains_in_residual(set, {900, 0.005}, residual));
}

}  // namespace percuss::identify::truncation_ripples_test
