#include "pipeline/channels/channel_delays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::channel_delays_test {

const std::vector<double> kModes_Hz{171, 174, 580, 598, 1190, 1204, 1840, 1862, 2131, 2603, 2630};

// Real modes in a channel that comes delay_s late, with random signs and phase errors of scatter_rad.
std::vector<ModePhase> phases(double delay_s, double scatter_rad, std::uint64_t seed, double std_rad = 0.003) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::bernoulli_distribution turned;
  std::vector<ModePhase> out;
  for (const double freq_Hz : kModes_Hz) {
    const double error = std::hypot(scatter_rad, std_rad) * normal(random);
    const double phase = -kTwoPi * freq_Hz * delay_s + error + (turned(random) ? kTwoPi / 2 : 0);
    out.push_back({.freq_Hz = freq_Hz, .phase_rad = std::remainder(phase, kTwoPi), .std_rad = std_rad});
  }
  return out;
}

TEST(ChannelDelays, FollowFromThePhasesOfAllModes) {
  for (const double delay_s : {-1e-3, -40e-6, 20e-6, 200e-6, 1e-3, 10e-3}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const auto found = delay_of_phases(phases(delay_s, 0, seed));
      ASSERT_TRUE(found);
      EXPECT_TRUE(found->established()) << delay_s;
      EXPECT_NEAR(found->delay_s, delay_s, 6 * found->std_s) << seed;
      EXPECT_LT(found->std_s, 0.3e-6);
    }
  }
}

TEST(ChannelDelays, StandardDeviationIsTrue) {
  double chi2 = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto found = delay_of_phases(phases(30e-6, 0.02, seed));
    chi2 += std::pow((found->delay_s - 30e-6) / found->std_s, 2) / 100;
  }
  // The mean of 100 squares scatters by 0.14, and more because each ± is estimated from 11 phases.
  EXPECT_GT(chi2, 0.5);
  EXPECT_LT(chi2, 2);
}

TEST(ChannelDelays, AreNotSeenInComplexShapes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    for (const double scatter_rad : {0.0, 0.05, 0.3, 1.0}) {
      const auto found = delay_of_phases(phases(0, scatter_rad, seed));
      EXPECT_FALSE(found->established() && found->largest_phase() > 0.05) << scatter_rad << ' ' << seed;
    }
  }
}

TEST(ChannelDelays, NeedThreeModes) {
  auto few = phases(20e-6, 0, 1);
  few.resize(2);
  EXPECT_FALSE(delay_of_phases(few));
}

TEST(ChannelDelays, JoinTheResiduesOfAllPoints) {
  std::vector<identify::Mode> modes;
  for (const double freq_Hz : kModes_Hz) {
    identify::Mode mode{.pole = {freq_Hz, 0.005}};
    for (std::size_t point = 0; point < 3; ++point) {
      for (std::size_t channel = 0; channel < 2; ++channel) {
        const double sign = (point + modes.size()) % 2 == 0 ? 1 : -1, delay_s = channel == 0 ? 0 : 25e-6;
        mode.residues.push_back({.point = point,
                                 .channel = channel,
                                 .value = std::polar(sign > 0 ? 2.0 : 1.0, -kTwoPi * freq_Hz * delay_s) * sign,
                                 .std = 1e-3});
      }
    }
    modes.push_back(mode);
  }
  const identify::FrfDataset set{.lines = {.fs_Hz = 8192, .samples = 8192, .first = 1, .count = 4000},
                                 .points = std::vector<identify::PointForce>(3),
                                 .channels = {}};
  const auto delays = delays_of_residues(set, modes, 2);
  ASSERT_EQ(delays.size(), 2U);
  EXPECT_FALSE(delays[0].established());
  EXPECT_TRUE(delays[1].established());
  EXPECT_NEAR(delays[1].delay_s, 25e-6, 1e-8);
}

// The noise of the force shifts its pulse in time, and with it the delays of all channels. The first sensor sees all
// modes, the second is at their nodes. The RMS of 12 standard normal values is within 1 ± 0.4 in 95 % of cases.
TEST(ChannelDelays, IncludeTheNoiseOfTheForce) {
  double squares = 0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    synth::SynthSpec spec =
        test::bat_spec({{.freq_Hz = 170, .damping_ratio = 0.003, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                        {.freq_Hz = 600, .damping_ratio = 0.003, .order = 2, .amplitude_per_sqrt_kg = 1.4},
                        {.freq_Hz = 1250, .damping_ratio = 0.003, .order = 3, .amplitude_per_sqrt_kg = 1.2},
                        {.freq_Hz = 2100, .damping_ratio = 0.003, .order = 4, .amplitude_per_sqrt_kg = 1.1}},
                       1);
    spec.seed = seed;
    spec.hits = 5;
    spec.noise = {.force = 5e-4, .accel = 1e-4};
    const Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
    for (const ChannelDelay& delay : analysis.channel_findings().delays) {
      squares += std::pow(delay.delay_s / delay.std_s, 2);  // there is no delay
      ++count;
    }
  }
  ASSERT_EQ(count, 12U);
  const double rms = std::sqrt(squares / static_cast<double>(count));
  EXPECT_GT(rms, 0.6);
  EXPECT_LT(rms, 1.4);
}

// The numbers of the points are no indices: one point may have any number.
TEST(ChannelDelays, AreFoundAtAPointOfAnyNumber) {
  acquire::Record record = synth::synthesise(test::bat_spec({{.freq_Hz = 170, .damping_ratio = 0.01, .order = 1},
                                                             {.freq_Hz = 600, .damping_ratio = 0.01, .order = 2},
                                                             {.freq_Hz = 1250, .damping_ratio = 0.01, .order = 3}},
                                                            1))
                               .record;
  const Analysis first(record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  for (acquire::RowInfo& row : record.rows) row.point = 1000;
  const Analysis numbered(record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  const auto &expected = first.channel_findings().delays, &delays = numbered.channel_findings().delays;
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(delays.size(), expected.size());
  for (std::size_t d = 0; d < delays.size(); ++d) {
    EXPECT_EQ(delays[d].delay_s, expected[d].delay_s);
    EXPECT_EQ(delays[d].std_s, expected[d].std_s);
  }
}

}  // namespace percuss::pipeline::channel_delays_test
