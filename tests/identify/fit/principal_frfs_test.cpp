#include "identify/fit/principal_frfs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/fit/joint_fit.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::principal_frfs_test {

const std::vector<Pole> kTruth{{300.3, 0.01}, {305, 0.012}, {420, 0.006}};

// Forty channels of three modes: residues as along a beam.
FrfDataset survey() {
  constexpr std::size_t kChannels = 40;
  FrfDataset set = test::empty_set(4096, 32768, 250, 500, kChannels);
  for (std::size_t o = 0; o < kChannels; ++o) {
    const double x = static_cast<double>(o) / kChannels;
    for (std::size_t m = 0; m < kTruth.size(); ++m)
      test::add_mode(set, o, kTruth[m], 0.5 * std::cos(3.1 * (static_cast<double>(m) + 1) * x + 0.4));
  }
  return set;
}

FrfDataset few_of(const FrfDataset& set) { return principal_frfs(set, principal_components(set, 8)); }

TEST(PrincipalFrfs, HoldThreeModesInThreeComponents) {
  constexpr double kRounding = 1e-9;  // of the energy
  const FrfDataset few = few_of(survey());
  ASSERT_EQ(few.channels.size(), 8U);
  std::vector<double> energy;
  for (const FrfChannel& channel : few.channels) {
    energy.push_back(0);
    for (const Complex& line : channel.frf) energy.back() += std::norm(line);
  }
  for (std::size_t i = 3; i < energy.size(); ++i) EXPECT_LE(energy[i], kRounding * energy[0]) << i;
}

// The truncation differs between the points' records. No point's truncation holds for a combination of their FRFs.
TEST(PrincipalFrfs, CountAsUntruncated) {
  FrfDataset set = survey();
  ASSERT_FALSE(set.points.at(0).blocks.empty());
  const Pole slow{300, 1e-5};
  ASSERT_FALSE(decays_within_record(slow, set.points[0], set.lines));
  const FrfDataset few = few_of(set);
  ASSERT_EQ(few.points.size(), 1U);
  EXPECT_TRUE(decays_within_record(slow, few.points[0], few.lines));
}

TEST(PrincipalFrfs, KeepTheInformationAboutThePoles) {
  constexpr double kTolerance = 0.05;  // scatter of a noise estimate from 4000 values
  FrfDataset set = survey();
  test::add_frf_noise(set, 0.5, 11);
  const JointFit all = fit_jointly(set, kTruth);
  const JointFit few = fit_jointly(few_of(set), kTruth);
  ASSERT_TRUE(all.converged && few.converged);
  for (std::size_t m = 0; m < kTruth.size(); ++m) {
    const auto i = static_cast<Eigen::Index>(m);
    EXPECT_LE(std::abs(few.freq_std_Hz(i) / all.freq_std_Hz(i) - 1), kTolerance) << m;
    EXPECT_LE(std::abs(few.poles[m].freq_Hz - all.poles[m].freq_Hz), 0.3 * all.freq_std_Hz(i)) << m;
    EXPECT_TRUE(few.real[m]) << m;
  }
}

}  // namespace percuss::identify::principal_frfs_test
