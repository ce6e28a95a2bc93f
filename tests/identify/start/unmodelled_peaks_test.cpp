#include "identify/start/unmodelled_peaks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::unmodelled_peaks_test {

constexpr double kRange_dB = 65;
const std::vector<Pole> kPoles{{200, 0.01}, {600, 0.005}, {1200, 0.004}};

FrfDataset three_peaks() {
  FrfDataset set = test::empty_set(4096, 16384, 60, 1500, 2);
  for (const Pole& pole : kPoles) {
    test::add_mode(set, 0, pole, 0.5);
    test::add_mode(set, 1, pole, 0.2);
  }
  test::add_frf_noise(set, 0.01, 3);
  return set;
}

std::vector<Mode> modes_of(const std::vector<Pole>& poles) {
  std::vector<Mode> modes;
  modes.reserve(poles.size());
  for (const Pole& pole : poles)
    modes.push_back({.pole = pole, .residues = {{.value = 0.5}, {.channel = 1, .value = 0.2}}});
  return modes;
}

TEST(UnmodelledPeaks, AreThePeaksWithoutAMode) {
  const FrfDataset set = three_peaks();
  EXPECT_TRUE(unmodelled_peaks(set, modes_of(kPoles), kRange_dB).empty());
  const auto peaks = unmodelled_peaks(set, modes_of({kPoles[0], kPoles[2]}), kRange_dB);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].freq_Hz, 600, set.lines.df_Hz());
  EXPECT_NEAR(peaks[0].level_dB, 20 * std::log10(0.004 / 0.005), 0.5) << "the tallest has the least damping";
}

TEST(UnmodelledPeaks, ExcludeThreeBandwidthsAroundAMode) {
  const FrfDataset set = three_peaks();
  EXPECT_TRUE(unmodelled_peaks(set, modes_of({kPoles[0], {615, 0.005}, kPoles[2]}), kRange_dB).empty());
  EXPECT_EQ(unmodelled_peaks(set, modes_of({kPoles[0], {625, 0.005}, kPoles[2]}), kRange_dB).size(), 1U);
}

TEST(UnmodelledPeaks, AreLimitedToTheForcesBandwidthAndTheRange) {
  FrfDataset set = three_peaks();
  set.usable_bandwidth_Hz = 700;
  EXPECT_EQ(unmodelled_peaks(set, {}, kRange_dB).size(), 2U);
  set.usable_bandwidth_Hz = 0;
  EXPECT_EQ(unmodelled_peaks(set, {}, kRange_dB).size(), 3U);
  EXPECT_EQ(unmodelled_peaks(set, {}, 1).size(), 1U);
}

// A peak must rise above its saddles by more than six standard deviations of the noise in its level, because on a flank
// noise can raise one line and lower its neighbour.
TEST(UnmodelledPeaks, AreNotNoiseOnAFlank) {
  constexpr double kNoise = 0.5;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    FrfDataset set = test::empty_set(8192, 8192, 60, 3000, 2);
    const Pole pole{1000, 0.05};
    test::add_mode(set, 0, pole, 0.5);
    test::add_mode(set, 1, pole, 0.2);
    test::add_frf_noise(set, kNoise, seed);
    EXPECT_TRUE(unmodelled_peaks(set, modes_of({pole}), kRange_dB).empty()) << seed;
  }
}

// The truncated decay of a mode makes ripples in its FRF, which look like peaks.
TEST(UnmodelledPeaks, AreNotTruncationRipples) {
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 400.3, .damping_ratio = 1e-5, .residue_per_kg = {1, 0.5}}}, 1);
  spec.points = {{}};
  const FrfDataset set = test::frf_set_of(synth::synthesise(spec, 1).record, 60, 2400);
  const Mode mode{.pole = {400.3, 1e-5}, .residues = {{.value = 1}, {.channel = 1, .value = 0.5}}};
  EXPECT_TRUE(unmodelled_peaks(set, {mode}, kRange_dB).empty());
  EXPECT_FALSE(unmodelled_peaks(set, {}, kRange_dB).empty());
}

// Near the end of the force's spectrum, the noise of the FRF rises, and the tail of a mode beyond the lines remains in
// the residual. Noise then makes prominent lines.
TEST(UnmodelledPeaks, ThatAreNoiseOnATailAreNotClear) {
  constexpr std::uint64_t kSeeds = 200;
  const Pole known{1390, 0.005}, beyond{1810, 0.006};
  std::size_t prominent = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    FrfDataset set = test::empty_set(5120, 10240, 1200, 1650, 1);
    test::add_frf_noise(set, 0.012, seed);
    set.points[0].ff.resize(set.lines.count);
    for (std::size_t k = 0; k < set.lines.count; ++k) {
      const double rise = std::exp((set.lines.freq_Hz(k) - 1550) / 30);
      set.channels[0].frf[k] *= rise;
      set.points[0].ff[k] = 1 / (rise * rise);
    }
    test::add_mode(set, 0, known, 0.02);
    test::add_mode(set, 0, beyond, 0.03);
    const auto peaks = unmodelled_peaks(set, {{.pole = known, .residues = {{.value = 0.02}}}}, kRange_dB);
    prominent += peaks.empty() ? 0U : 1U;
    EXPECT_TRUE(clear_of_noise(set, peaks).empty()) << seed;
  }
  EXPECT_GE(prominent, 5U) << "otherwise this test shows nothing";
}

TEST(UnmodelledPeaks, AreClearWhereAModeStandsOutOfTheNoise) {
  constexpr std::uint64_t kSeeds = 20;
  const Pole weak{1390, 0.005};
  for (const std::size_t channels : {1U, 8U}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      FrfDataset set = test::empty_set(5120, 10240, 1200, 1650, channels);
      for (std::size_t c = 0; c < channels; ++c) {
        test::add_mode(set, c, {1810, 0.006}, 0.01);
        test::add_mode(set, c, weak, 0.001);  // 0.1 at the peak
      }
      test::add_frf_noise(set, 0.0035, seed);
      const auto peaks = clear_of_noise(set, unmodelled_peaks(set, {}, kRange_dB));
      ASSERT_EQ(peaks.size(), 1U) << seed;
      EXPECT_NEAR(peaks[0].freq_Hz, weak.freq_Hz, 2 * weak.half_power_Hz());
    }
  }
}

// A strong mode of the margin, left in the residual, leaves a broad residual in the band. There, a hump between two
// antiresonances, which is no resonance, is a prominent peak.
TEST(UnmodelledPeaks, AreNotHumpsBesideAModeOfTheMargin) {
  const std::vector<std::pair<Pole, double>> parts{
      {{822, 0.0031}, 0.9},   {{831.5, 0.0027}, 0.5}, {{1463, 0.0022}, 0.54}, {{2118, 0.0035}, 0.56},
      {{2951, 0.0018}, 0.23}, {{3622, 0.004}, -0.21}, {{5240, 0.0026}, 0.28}, {{7300, 0.003}, 0.81}};
  FrfDataset set = test::empty_set(25600, 16384, 150, 7528, 1);
  std::vector<Mode> modes;
  for (const auto& [pole, residue] : parts) {
    test::add_mode(set, 0, pole, residue);
    modes.push_back({.pole = pole, .residues = {{.value = residue}}});
  }
  test::add_mode(set, 0, {5.2, 0.05}, 0.29);  // the suspension, below the lines
  test::add_mode(set, 0, {7.8, 0.06}, -0.19);
  test::add_frf_noise(set, 0.02, 1);
  const std::vector<Mode> beyond{modes.back()};
  modes.pop_back();
  const auto in_band = [](const UnmodelledPeak& peak) { return peak.freq_Hz < 6000; };
  const auto left = unmodelled_peaks(set, modes, kRange_dB);
  EXPECT_TRUE(std::any_of(left.begin(), left.end(), in_band)) << "otherwise this test shows nothing";
  EXPECT_TRUE(unmodelled_peaks(set, modes, kRange_dB, beyond).empty());
  modes.erase(modes.begin() + 5);
  const auto peaks = unmodelled_peaks(set, modes, kRange_dB, beyond);
  EXPECT_TRUE(std::any_of(peaks.begin(), peaks.end(), [&](const UnmodelledPeak& peak) {
    return std::abs(peak.freq_Hz - 3622) < 3 * set.lines.df_Hz();
  })) << "a mode is missing";
}

}  // namespace percuss::identify::unmodelled_peaks_test
