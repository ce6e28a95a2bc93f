#include "pipeline/stages/mains_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kStrong_Hz = 431;
const std::vector<Tone> kHum = {{.freq_Hz = 49.99}, {.freq_Hz = 120.3}};

identify::Mode mode_at(double freq_Hz, double half_power_Hz, Complex residue) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = freq_Hz, .damping_ratio = half_power_Hz / freq_Hz / 2};
  mode.residues = {{.value = residue}};
  return mode;
}

// A strong mode, alike in all hits, and a weak one whose phase advances by `turns` from hit to hit. Each hit is an
// impulse of 1 N.
struct Hits {
  identify::FrfDataset set = test::empty_set(2000, 2000, 10, 990, 1);
  identify::HitFrfs frfs{.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz}};
  std::vector<std::vector<Complex>> spectra;
  std::vector<identify::Mode> modes = {mode_at(kStrong_Hz, 4, 100)};

  Hits(const identify::Mode& weak, std::size_t hits, double turns) {
    test::add_frf_noise(set, 1e-4, 1);
    Complex mean;
    for (std::size_t h = 0; h < hits; ++h) {
      const Complex phase = std::polar(1.0, kTwoPi * turns * static_cast<double>(h));
      identify::FrfDataset one = test::empty_set(2000, 2000, 10, 990, 1);
      test::add_mode(one, 0, modes.front().pole, modes.front().residues.front().value);
      test::add_mode(one, 0, weak.pole, weak.residues.front().value * phase);
      test::add_frf_noise(one, 1e-4, h + 2);
      const Complex* const force = one.points.front().spectra.front().get();
      for (std::size_t k = 0; k < one.lines.count; ++k) one.channels.front().frf[k] *= force[k];
      mean += phase / static_cast<double>(hits);
      spectra.push_back(one.channels.front().frf);
      frfs.set.points.push_back(one.points.front());
      frfs.set.channels.push_back({.point = h, .channel = 0, .frf = {}});
      frfs.points.push_back(0);
    }
    for (const std::vector<Complex>& spectrum : spectra) frfs.accel.emplace_back(spectrum);
    modes.push_back(weak);
    modes.back().residues.front().value *= mean;
    std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  }
  std::size_t modes_left() {
    remove_mains_modes(modes, kHum, set, frfs);
    return modes.size();
  }
};

std::size_t modes_left(double freq_Hz, double half_power_Hz, std::size_t hits, double turns) {
  return Hits(mode_at(freq_Hz, half_power_Hz, 1), hits, turns).modes_left();
}

// 0.23 turns from hit to hit leave 0.14 of the residue in the mean of five hits, and a coherence of 0.02. The flank of
// the strong mode follows the force at every line.
TEST(MainsModes, RemovesANarrowHarmonicWhoseResiduesDoNotFollowTheForce) {
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23), 1U);
}

TEST(MainsModes, KeepsWhatFollowsTheForce) { EXPECT_EQ(modes_left(449.8, 0.9, 5, 0), 2U); }

TEST(MainsModes, KeepsModesBesideHarmonicsAndBroadModes) {
  EXPECT_EQ(modes_left(461, 0.9, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(449.8, 3, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(240.6, 0.9, 5, 0.23), 2U);  // a multiple of a tone that is not of the mains
}

// Two hits with independent phases often have a high coherence, and a low coherence of two hits proves little.
TEST(MainsModes, NeedsThreeHits) {
  EXPECT_EQ(modes_left(449.8, 0.9, 2, 0.4), 2U);
  EXPECT_EQ(modes_left(449.8, 0.9, 3, 0.4), 1U);
}

}  // namespace
}  // namespace percuss::pipeline
