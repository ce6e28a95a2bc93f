#include "identify/model/frf_synthesis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::frf_synthesis_test {

constexpr double kRounding = 1e-12;

Mode mode_of(const Pole& pole, std::vector<Complex> residues) {
  Mode mode{.pole = pole};
  for (std::size_t o = 0; o < residues.size(); ++o)
    mode.residues.push_back({.point = 0, .channel = o, .value = residues[o]});
  return mode;
}

// Two channels of two modes. The second channel also has a mass line.
struct Case {
  FrfDataset set = test::empty_set(8192, 16384, 50, 2000, 2);
  std::vector<Mode> modes{mode_of({300, 0.01}, {1.0, -0.4}), mode_of({1100, 0.004}, {0.5, {0.2, 0.05}})};
  Case() {
    for (const Mode& mode : modes) {
      for (std::size_t o = 0; o < 2; ++o) test::add_mode(set, o, mode.pole, mode.residues[o].value);
    }
    for (Complex& h : set.channels[1].frf) h += 0.7;
  }
};

TEST(SynthesisedFrf, EqualsTheMeasuredFrfForExactModes) {
  const Case c;
  const auto made = synthesised_frfs(c.set, c.modes, c.set.lines);
  ASSERT_EQ(made.size(), 2U);
  for (std::size_t o = 0; o < 2; ++o) {
    EXPECT_NEAR(made[o].frac, 1, kRounding);
    for (std::size_t k = 0; k < c.set.lines.count; ++k)
      ASSERT_LE(std::abs(made[o].value[k] - c.set.channels[o].frf[k]), 1e-10) << k;  // of a peak of 60
  }
  EXPECT_NEAR(std::abs(made[1].terms[0] - Complex(0.7)), 0, 1e-10);
  EXPECT_NEAR(std::abs(made[1].terms[1]), 0, 1e-10);
}

TEST(SynthesisedFrf, FollowsAModeAboveTheBand) {
  constexpr double kClose = 1e-12;  // r_2, r_4 and r_6 are the first three terms of the mode's series
  Case c;
  test::add_mode(c.set, 0, {6000, 0.01}, 2.0);
  EXPECT_LE(1 - synthesised_frfs(c.set, c.modes, c.set.lines)[0].frac, kClose);
}

// At the end of the band, the flank of the mode is a fifth of the FRF's largest magnitude. The residual terms r_0, r_2
// and r_4 alone leave 0.6 % of the energy, all four 0.12 %.
TEST(SynthesisedFrf, FollowsTheFlankOfAModeJustAboveTheBand) {
  Case c;
  test::add_mode(c.set, 0, {2150, 0.03}, 2.0);
  EXPECT_LE(1 - synthesised_frfs(c.set, c.modes, c.set.lines)[0].frac, 2e-3);
}

// The powers of s are nearly dependent over a narrow band: their Gram matrix has a condition number of 10¹⁴.
TEST(SynthesisedFrf, FitsTheTermsOfANarrowBand) {
  Case c;
  const acquire::LineRange narrow{
      .fs_Hz = c.set.lines.fs_Hz, .samples = c.set.lines.samples, .first = 3800, .count = 60};
  for (const SynthesisedFrf& made : synthesised_frfs(c.set, c.modes, narrow)) EXPECT_NEAR(made.frac, 1, kRounding);
  const acquire::LineRange three{.fs_Hz = narrow.fs_Hz, .samples = narrow.samples, .first = 3800, .count = 3};
  for (const SynthesisedFrf& made : synthesised_frfs(c.set, {}, three)) EXPECT_NEAR(made.frac, 1, kRounding);
}

TEST(SynthesisedFrf, LacksAnOmittedMode) {
  Case c;
  c.modes.pop_back();
  for (const SynthesisedFrf& made : synthesised_frfs(c.set, c.modes, c.set.lines)) EXPECT_LE(made.frac, 0.9);
}

TEST(SynthesisedFrf, UsesAPointsOwnPole) {
  Case c;
  Mode& mode = c.modes.front();
  const Pole own = mode.pole;
  mode.pole.freq_Hz += own.half_power_Hz();
  EXPECT_LE(synthesised_frfs(c.set, c.modes, c.set.lines)[0].frac, 0.99);
  for (Residue& residue : mode.residues) residue.own_pole = own;
  EXPECT_NEAR(synthesised_frfs(c.set, c.modes, c.set.lines)[0].frac, 1, kRounding);
}

TEST(SynthesisedFrf, SeparatesNoiseFromOmittedModes) {
  Case c;
  test::add_frf_noise(c.set, 1, 3);
  EXPECT_NEAR(synthesised_frfs(c.set, c.modes, c.set.lines)[0].noise_share, 1, 0.05);  // 3901 lines
  Case missing;
  missing.modes.pop_back();
  EXPECT_LE(synthesised_frfs(missing.set, missing.modes, missing.set.lines)[0].noise_share, 0.05);  // a smooth curve
}

TEST(SynthesisedFrf, StatesLevelsRelativeToTheStrongestFrf) {
  Case c;
  for (std::size_t k = 0; k < c.set.lines.count; ++k) c.set.channels[1].frf[k] = 0.1 * c.set.channels[0].frf[k];
  const auto made = synthesised_frfs(c.set, c.modes, c.set.lines);
  EXPECT_EQ(made[0].level_dB, 0);
  EXPECT_NEAR(made[1].level_dB, -20, kRounding * 100);
}

TEST(SynthesisedFrf, AcceptsADeadChannelAndNoModes) {
  Case c;
  c.set.channels[1].frf.assign(c.set.lines.count, Complex());
  const auto made = synthesised_frfs(c.set, {}, c.set.lines);
  EXPECT_EQ(made[1].frac, 0);
  EXPECT_TRUE(std::isfinite(made[1].level_dB));
}

TEST(SynthesisedFrf, IncludesTruncatedDecays) {
  constexpr double kClose = 1e-6;  // the mass line, and the filter near the band's end
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 300, .damping_ratio = 0.002}}, 0.3);
  const auto made = synth::synthesise(spec);
  const FrfDataset set = test::frf_set_of(made.record, 60, 2400);
  Mode mode{.pole = {300, 0.002}};
  for (std::size_t c = 0; c < 2; ++c)
    mode.residues.push_back({.channel = c, .value = made.truth.residue_per_kg[0][c][0]});
  for (const SynthesisedFrf& frf : synthesised_frfs(set, {mode}, set.lines)) EXPECT_LE(1 - frf.frac, kClose);
}

TEST(Frac, DoesNotDependOnScale) {
  using Frf = std::vector<Complex>;
  EXPECT_NEAR(frac(Frf{1, {0, 2}, 3}, Frf{{0, 5}, -10, {0, 15}}), 1, kRounding);
  EXPECT_NEAR(frac(Frf{1, 0}, Frf{0, 1}), 0, kRounding);
  EXPECT_EQ(frac(Frf{0, 0}, Frf{0, 1}), 0);
}

TEST(ResidualsFromSums, AreTheMeasuredLessTheSynthesisedFrfs) {
  Case c;
  c.modes.pop_back();  // so that a resonance remains
  const auto made = synthesised_frfs(c.set, c.modes, c.set.lines);
  const auto left = residuals_from_sums(c.set, modal_sums(c.set, c.modes));
  ASSERT_EQ(left.size(), c.set.channels.size());
  for (std::size_t o = 0; o < left.size(); ++o) {
    const Eigen::Map<const Eigen::VectorXcd> measured(c.set.channels[o].frf.data(), left[o].size());
    const Eigen::Map<const Eigen::VectorXcd> synthesised(made[o].value.data(), left[o].size());
    EXPECT_GT(left[o].norm(), 0.01 * measured.norm());
    EXPECT_LE((measured - synthesised - left[o]).norm(), kRounding * measured.norm());
  }
}

}  // namespace percuss::identify::frf_synthesis_test
