#include "identify/multi_output.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::multi_output_test {

constexpr double kDeviations = 4.5;  // standard deviations
constexpr std::size_t kChannels = 30;
const std::vector<Pole> kTruth{{300.3, 0.01}, {306, 0.009}, {420, 0.006}};

double shape(std::size_t channel, std::size_t mode) {
  return 0.5 * std::cos(3.1 * (static_cast<double>(mode) + 1) * static_cast<double>(channel) / kChannels + 0.4);
}

FrfDataset survey(double freq_scatter_Hz, std::uint64_t seed) {
  FrfDataset set = test::empty_set(4096, 32768, 250, 500, kChannels);
  set.points.resize(kChannels, set.points.front());
  for (std::size_t o = 0; o < kChannels; ++o) {
    set.channels[o].point = o;
    set.channels[o].channel = 0;
    for (std::size_t m = 0; m < kTruth.size(); ++m) {
      Pole pole = kTruth[m];
      pole.freq_Hz += freq_scatter_Hz * std::sin(7.0 * static_cast<double>(o));
      test::add_mode(set, o, pole, shape(o, m));
    }
  }
  test::add_frf_noise(set, 0.05, seed);
  return set;
}

TEST(IdentifyMultiOutput, FindsPolesAndResiduesWithinTheirStandardDeviations) {
  for (const Effort effort : {Effort::standard, Effort::best}) {
    const auto modes = identify_multi_output(survey(0, 3), {.effort = effort});
    ASSERT_TRUE(modes);
    ASSERT_EQ(modes->size(), kTruth.size());
    for (std::size_t m = 0; m < kTruth.size(); ++m) {
      const Mode& mode = (*modes)[m];
      EXPECT_LE(std::abs(mode.pole.freq_Hz - kTruth[m].freq_Hz), kDeviations * mode.freq_std_Hz) << m;
      EXPECT_LE(std::abs(mode.pole.damping_ratio - kTruth[m].damping_ratio), kDeviations * mode.damping_std) << m;
      ASSERT_EQ(mode.residues.size(), kChannels);
      for (std::size_t o = 0; o < kChannels; ++o) {
        EXPECT_EQ(mode.residues[o].point, o);
        EXPECT_LE(std::abs(mode.residues[o].value - shape(o, m)), std::sqrt(2) * kDeviations * mode.residues[o].std);
      }
    }
  }
}

TEST(IdentifyMultiOutput, DeclinesASurveyWithFrequencyScatter) {
  EXPECT_FALSE(identify_multi_output(survey(0.5, 3), {}));
}

TEST(IdentifyMultiOutput, FitsTruncatedRecords) {
  // 1 % of the first mode's amplitude is left at the end; the missing decay is added from the first fit.
  synth::SynthSpec spec = test::bat_spec(
      {{.freq_Hz = 180, .damping_ratio = 0.005}, {.freq_Hz = 600, .damping_ratio = 0.004, .order = 2}}, 0.8);
  spec.points.clear();
  for (std::size_t p = 0; p < 10; ++p)
    spec.points.push_back({.position_m = 0.05 + 0.05 * static_cast<double>(p), .angle_rad = 0.35});
  spec.noise = {.force = 0, .accel = 1e-4};
  const synth::SyntheticTest made = synth::synthesise(spec);
  const auto modes = identify_multi_output(test::frf_set_of(made.record, 30, 2400), {});
  ASSERT_TRUE(modes);
  ASSERT_EQ(modes->size(), 2U);
  EXPECT_LE(std::abs((*modes)[0].pole.freq_Hz - 180), kDeviations * (*modes)[0].freq_std_Hz);
  EXPECT_LE(std::abs((*modes)[0].pole.damping_ratio - 0.005), kDeviations * (*modes)[0].damping_std);
}

}  // namespace percuss::identify::multi_output_test
