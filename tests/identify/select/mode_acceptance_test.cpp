#include "identify/select/mode_acceptance.hpp"

#include <gtest/gtest.h>

#include "identify/noise/force_noise.hpp"
#include "identify/select/sequential_fit.hpp"
#include "identify/start/candidates.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::mode_acceptance_test {

constexpr double kNoise_N = 1e-3;  // of a pulse of 1 N
constexpr int kTrials = 20;
const Pole kStrong{500, 0.003}, kWeak{503.6, 0.003};

// A strong mode, and a weak one 1.2 bandwidths beside it.
FrfDataset measured(double weak, std::uint64_t seed) {
  FrfDataset set = test::empty_set(8192, 8192, 60, 2400, 2);
  test::set_gated_pulse(set, kNoise_N);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    const double sign = channel == 0 ? 1 : -0.8;
    test::add_mode(set, channel, kStrong, sign);
    test::add_mode(set, channel, kWeak, sign * weak);
  }
  test::add_random_gain(set, seed);
  test::add_frf_noise(set, 0.01, seed + 1000);  // a fiftieth of the weak peak
  return set;
}

// The force's noise scales both modes alike, so that it cannot cause the weak peak.
TEST(ModeAcceptance, KeepsAWeakModeBelowTheForceNoiseOfAStrongOne) {
  constexpr double kPart = 1.0 / 250;
  for (std::uint64_t seed = 0; seed < kTrials; ++seed) {
    const FrfDataset set = measured(kPart, seed);
    EXPECT_LT(kPart, 8 * gain_std(set, 0, kWeak.freq_Hz));
    const auto modes = fit_sequentially(set);
    ASSERT_EQ(modes.size(), 2U) << seed;
    EXPECT_NEAR(modes[1].mode.pole.freq_Hz, kWeak.freq_Hz, 4.5 * modes[1].mode.freq_std_Hz) << seed;
  }
}

TEST(ModeAcceptance, TakesNoModeFromTheForceNoise) {
  for (std::uint64_t seed = 0; seed < kTrials; ++seed)
    EXPECT_EQ(fit_sequentially(measured(0, seed)).size(), 1U) << seed;
}

// The force of two hits; the second hit has a second contact 300 samples after the pulse, within a part of the gate of
// its own.
void set_two_part_gate(FrfDataset& set) {
  test::set_gated_pulse(set, kNoise_N);
  std::vector<frf::ForceBlock> blocks(2, set.points[0].blocks[0]);
  std::vector<double>& twice = blocks[1].force_N;
  twice.resize(300);
  for (std::size_t n = 0; n < 30; ++n) twice.push_back(0.01);
  std::vector<frf::Spectrum> spectra;
  for (const frf::ForceBlock& block : blocks)
    spectra.push_back(test::make_spectrum(frf::force_spectrum(block, set.lines)));
  set.points[0] = point_force(blocks, spectra, set.lines, kNoise_N);
}

// The force's noise in the strong FRFs can fit a pole whose small residue in a weak FRF is the response's noise. It
// does so with these two of 150 seeds.
TEST(ModeAcceptance, TakesNoModeFromTheNoiseOfASecondContact) {
  for (const std::uint64_t seed : {42U, 101U}) {
    FrfDataset set = test::empty_set(8192, 8192, 60, 2400, 3);
    set_two_part_gate(set);
    constexpr double kShape[] = {1, -0.8, 0.03}, kOther[] = {0.5, 0.6, -0.7};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      test::add_mode(set, channel, kStrong, kShape[channel]);
      test::add_mode(set, channel, {900, 0.003}, kOther[channel]);
    }
    test::add_random_gain(set, seed);
    test::add_frf_noise(set, 0.01, seed + 1000);
    EXPECT_EQ(fit_sequentially(set).size(), 2U) << seed;
  }
}

// Two modes lie little more than a line apart, and one mode cannot describe both. During the search such a mode is
// accepted, so that its partner can be found. After the search it is not.
TEST(ModeAcceptance, KeepsAPeakDuringTheSearchWhereTheModeBesideItIsMissing) {
  FrfDataset set = test::empty_set(4096, 2048, 300, 1500, 1);
  for (const double freq_Hz : {500.0, 1200.0}) test::add_mode(set, 0, {freq_Hz, 0.004}, 1);
  test::add_mode(set, 0, {800.3, 0.0003}, 1);
  test::add_mode(set, 0, {802.7, 0.0003}, 0.9);
  test::add_frf_noise(set, 0.01, 7);
  AcceptanceContext context{.peak_poles = candidate_poles(set, LineNoise(set))};
  ASSERT_EQ(context.peak_poles.size(), 3U);
  WindowedFit all(set);
  all.replace(context.peak_poles);
  all.sweep();
  ASSERT_EQ(all.groups().size(), 3U);
  EXPECT_TRUE(accept_mode(all, all.groups()[1], 0, context));
  context.search_finished = true;
  EXPECT_FALSE(accept_mode(all, all.groups()[1], 0, context));
  EXPECT_EQ(fit_sequentially(set).size(), 4U);
}

}  // namespace percuss::identify::mode_acceptance_test
