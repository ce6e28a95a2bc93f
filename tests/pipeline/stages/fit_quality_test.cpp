#include "pipeline/stages/fit_quality.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::pipeline::fit_quality_test {

const identify::Pole kLow{300, 0.01}, kHigh{700, 0.01};

// Two modes in one FRF, with a mass line of 0.5/kg and a residual flexibility of 2e-8 m/N.
identify::FrfDataset two_modes() {
  identify::FrfDataset set = test::empty_set(4000, 8000, 100, 1000, 1);
  test::add_mode(set, 0, kLow, 2);
  test::add_mode(set, 0, kHigh, -1.5);
  for (std::size_t k = 0; k < set.lines.count; ++k) {
    const double omega = kTwoPi * set.lines.freq_Hz(k);
    set.channels[0].frf[k] += 0.5 - 2e-8 * omega * omega;
  }
  return set;
}

identify::Mode mode(const identify::Pole& pole, double residue) {
  return {.pole = pole, .residues = {{.value = residue, .std = 1e-6}}};
}

FitQuality quality(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes) {
  return fit_quality(set, modes, identify::synthesised_frfs(set, modes, set.lines), set.lines);
}

TEST(FitQuality, GivesTheResidualTermsInTheirUnits) {
  const identify::FrfDataset set = two_modes();
  const FitQuality fit = quality(set, {mode(kLow, 2), mode(kHigh, -1.5)});
  ASSERT_EQ(fit.frfs.size(), 1U);
  constexpr double kRounding = 1e-9;  // relative, of a least-squares fit; measured 2e-15
  EXPECT_NEAR(fit.frfs[0].frac, 1, kRounding);
  EXPECT_NEAR(fit.frfs[0].lower.real() / 0.5, 1, kRounding);
  EXPECT_NEAR(fit.frfs[0].upper.real() / 2e-8, 1, kRounding);
  EXPECT_NEAR(fit.mode_frac[0], 1, kRounding);
}

TEST(FitQuality, FallsWhereAModeIsMissing) {
  const identify::FrfDataset set = two_modes();
  const FitQuality fit = quality(set, {mode(kLow, 2)});
  EXPECT_LT(fit.frfs[0].frac, 0.9);
  EXPECT_GT(fit.mode_frac[0], 0.99);
  const auto peaks = unexplained_peaks_of(set, {mode(kLow, 2)});
  ASSERT_FALSE(peaks.empty());
  EXPECT_NEAR(peaks.front().freq_Hz, kHigh.freq_Hz, set.lines.df_Hz());
}

}  // namespace percuss::pipeline::fit_quality_test
