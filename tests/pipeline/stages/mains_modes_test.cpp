#include "pipeline/stages/mains_modes.hpp"

#include <gtest/gtest.h>

namespace percuss::pipeline {
namespace {

// 1 Hz apart, from 0 Hz.
const acquire::LineRange kLines{.fs_Hz = 2000, .samples = 2000, .first = 0, .count = 1000};
const std::vector<Tone> kHum = {{.freq_Hz = 49.99}, {.freq_Hz = 120.3}};

identify::Mode mode_at(double freq_Hz, double half_power_Hz) {
  identify::Mode mode;
  mode.pole = {.freq_Hz = freq_Hz, .damping_ratio = half_power_Hz / freq_Hz / 2};
  return mode;
}

std::size_t modes_left(const identify::Mode& mode, double coherence, std::size_t averages) {
  acquire::PointFrf frf;
  frf.frf.coherence.assign(kLines.count, coherence);
  frf.frf.averages = averages;
  std::vector<identify::Mode> modes = {mode};
  remove_mains_modes(modes, kHum, kLines, {frf});
  return modes.size();
}

TEST(MainsModes, RemovesANarrowHarmonicThatDoesNotFollowTheForce) {
  EXPECT_EQ(modes_left(mode_at(449.8, 0.2), 0.4, 5), 0U);
}

TEST(MainsModes, KeepsWhatFollowsTheForce) { EXPECT_EQ(modes_left(mode_at(449.8, 0.2), 0.9, 5), 1U); }

TEST(MainsModes, KeepsModesBesideHarmonicsAndBroadModes) {
  EXPECT_EQ(modes_left(mode_at(431, 0.2), 0.4, 5), 1U);
  EXPECT_EQ(modes_left(mode_at(449.8, 3), 0.4, 5), 1U);
  EXPECT_EQ(modes_left(mode_at(240.6, 0.2), 0.4, 5), 1U);  // a multiple of a tone that is not of the mains
}

// Two hits with independent phases often have a high coherence, and a low coherence of two hits proves little.
TEST(MainsModes, NeedsThreeHits) {
  EXPECT_EQ(modes_left(mode_at(449.8, 0.2), 0.4, 2), 1U);
  EXPECT_EQ(modes_left(mode_at(449.8, 0.2), 0.4, 3), 0U);
}

}  // namespace
}  // namespace percuss::pipeline
