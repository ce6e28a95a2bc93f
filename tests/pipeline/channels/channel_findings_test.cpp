// Each record has one fault of its channels, whose size is exactly known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "pipeline/analysis.hpp"
#include "support/changed_record.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::channel_findings_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kEighthTurn_rad = std::numbers::pi / 4;

constexpr std::array kFreq_Hz{171.0, 580.0, 1190.0, 1840.0, 2350.0};
constexpr double kDamping = 0.006;

// A bat with bending in oblique planes, so that both sensors see every mode.
synth::SynthSpec oblique_bat() {
  std::vector<synth::SynthMode> modes;
  for (std::size_t m = 0; m < kFreq_Hz.size(); ++m) {
    modes.push_back({.freq_Hz = kFreq_Hz.at(m),
                     .damping_ratio = kDamping,
                     .order = static_cast<int>(m) + 1,
                     .angle_rad = kEighthTurn_rad + 0.3 * static_cast<double>(m % 3) - 0.3,
                     .amplitude_per_sqrt_kg = 2});
  }
  synth::SynthSpec spec = test::bat_spec(modes, 1);
  spec.hits = 3;
  spec.pretrigger_s = 0.01;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return spec;
}

acquire::Record late_by(const acquire::Record& record, std::size_t first, std::size_t second) {
  return test::with_changed_accel(record, [=](std::size_t, std::size_t channel, std::vector<double>& x) {
    const auto late = static_cast<std::ptrdiff_t>(channel == 0 ? first : second);
    std::copy_backward(x.begin(), x.end() - late, x.end());
    std::fill_n(x.begin(), late, x.front());
  });
}

std::vector<std::string> warnings_of(const Analysis& analysis) {
  analysis.classifications();
  return test::lines_of_messages(analysis.warnings());
}

const AnalysisOptions kBand{.band_Hz = std::pair{60.0, 2800.0}, .threads = 1};

AnalysisOptions automatic() {
  AnalysisOptions options = kBand;
  options.delays.automatic = true;
  return options;
}

TEST(ChannelFindings, AreNoneForGoodChannels) {
  EXPECT_THAT(warnings_of(Analysis(synth::synthesise(oblique_bat()).record, kBand)),
              Not(Contains(testing::AnyOf(StartsWith("skew"), StartsWith("clock"), StartsWith("units"),
                                          StartsWith("implausible"), StartsWith("reversed"), StartsWith("same")))));
}

TEST(ChannelFindings, NameADelayWithItsNumber) {
  // One sample and three samples of 122.07 µs.
  const acquire::Record record = late_by(synth::synthesise(oblique_bat()).record, 1, 3);
  const Analysis analysis(record, kBand);
  EXPECT_THAT(warnings_of(analysis), Contains(AllOf(StartsWith("skew: "), HasSubstr("122.1"), HasSubstr("366.2"))));
  const std::vector<ChannelDelay>& delays = analysis.channel_findings().delays;
  ASSERT_EQ(delays.size(), 2U);
  for (const ChannelDelay& delay : delays) {
    const double truth_s = (delay.channel == 0 ? 1 : 3) / record.fs_Hz;
    EXPECT_NEAR(delay.delay_s, truth_s, 5 * delay.std_s + 0.05e-6);
  }
}

TEST(ChannelFindings, TakeADelayOut) {
  const acquire::Record good = synth::synthesise(oblique_bat()).record;
  const Analysis expected(good, kBand);
  for (const auto& [first, second] : {std::pair{1, 3}, std::pair{26, 26}, std::pair{256, 256}}) {
    const Analysis analysis(late_by(good, static_cast<std::size_t>(first), static_cast<std::size_t>(second)),
                            automatic());
    ASSERT_EQ(analysis.modes().size(), expected.modes().size()) << second;
    for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
      const identify::Mode &got = analysis.modes()[m], &want = expected.modes()[m];
      // Against the truth: whether a mode is fitted alone or with all others may differ between the two analyses.
      EXPECT_NEAR(got.pole.freq_Hz, kFreq_Hz.at(m), 3 * got.freq_std_Hz) << second;
      EXPECT_NEAR(got.pole.damping_ratio, kDamping, 3 * got.damping_std) << second;
      EXPECT_LT(got.freq_std_Hz, 2 * want.freq_std_Hz) << second;
      EXPECT_LT(std::abs(std::arg(got.residues[1].value / want.residues[1].value)), 0.02) << second;
    }
    EXPECT_THAT(warnings_of(analysis), Contains(StartsWith("skew: delays were taken out")));
  }
}

TEST(ChannelFindings, TakeAStatedDelayOut) {
  AnalysisOptions options = kBand;
  const acquire::Record good = synth::synthesise(oblique_bat()).record;
  options.delays.delay_s = {0, 3 / good.fs_Hz};
  const Analysis analysis(late_by(good, 0, 3), options);
  EXPECT_THAT(warnings_of(analysis), Not(Contains(StartsWith("skew"))));
}

TEST(ChannelFindings, NameChannelsWithTheirOwnClock) {
  // The second channel's structure is 50 ppm faster: the same as a recorder that is 50 ppm slower.
  synth::SynthSpec fast = oblique_bat();
  for (synth::SynthMode& mode : fast.modes) mode.freq_Hz *= 1 + 50e-6;
  const acquire::Record slow = synth::synthesise(oblique_bat()).record, other = synth::synthesise(fast).record;
  acquire::Record record = slow;
  record.contiguous.clear();
  record.read_accel_mps2 = [a = slow.read_accel_mps2, b = other.read_accel_mps2](
                               std::size_t row, std::size_t channel, std::size_t first, std::span<double> to) {
    channel == 0 ? a(row, channel, first, to) : b(row, channel, first, to);
  };
  const Analysis analysis(record, kBand);
  EXPECT_THAT(warnings_of(analysis), Contains(AllOf(StartsWith("clock_mismatch: "), HasSubstr("ppm higher"))));
  ASSERT_EQ(analysis.channel_findings().clocks.size(), 1U);
  const ChannelClock& clock = analysis.channel_findings().clocks.front();
  EXPECT_NEAR(clock.excess, 50e-6, 5 * clock.std);
}

// A bat struck in line with the first sensor: bending in the plane of the blow, and split hoop modes.
synth::SynthSpec bat_in_line() {
  std::vector<synth::SynthMode> modes;
  for (const auto& [freq_Hz, order] : {std::pair{182.0, 1}, std::pair{622.0, 2}, std::pair{1265.0, 3}})
    modes.push_back({.freq_Hz = freq_Hz, .damping_ratio = kDamping, .order = order, .amplitude_per_sqrt_kg = 1.7});
  for (const auto& [freq_Hz, angle_deg, order] :
       {std::tuple{1900.0, 12.0, 1}, std::tuple{1912.0, 57.0, 1}, std::tuple{2650.0, 12.0, 2}}) {
    modes.push_back({.freq_Hz = freq_Hz,
                     .damping_ratio = 0.003,
                     .type = synth::SynthModeType::hoop,
                     .order = order,
                     .angle_rad = angle_deg * kDegree_rad,
                     .amplitude_per_sqrt_kg = 2.7});
  }
  synth::SynthSpec spec = test::bat_spec(modes, 1);
  spec.points = {{.angle_rad = 0}};
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return spec;
}

TEST(ChannelFindings, FindNoFaultOfABatStruckInLineWithASensor) {
  const Analysis analysis(synth::synthesise(bat_in_line()).record, kBand);
  EXPECT_THAT(warnings_of(analysis), Not(Contains(testing::AnyOf(StartsWith("reversed"), StartsWith("units")))));
  ASSERT_EQ(analysis.modes().size(), 6U);
}

TEST(ChannelFindings, NameAReversedSensorOfATube) {
  synth::SynthSpec spec = bat_in_line();
  for (std::size_t m = 0; m < 3; ++m) spec.modes[m].angle_rad = 30 * kDegree_rad;
  EXPECT_THAT(warnings_of(Analysis(synth::synthesise(spec).record, kBand)), Not(Contains(StartsWith("reversed"))));
  spec.sensors[1].sign = -1;
  EXPECT_THAT(warnings_of(Analysis(synth::synthesise(spec).record, kBand)), Contains(StartsWith("reversed: ")));
}

// Hoop modes in one direction, and bending in the plane of the blow if wanted. Of three sensors, the third has no
// angle.
synth::SynthSpec bat_with_three_sensors(bool bending, double third_rad) {
  std::vector<synth::SynthMode> modes;
  for (const auto& [freq_Hz, order] : {std::pair{171.0, 1}, std::pair{580.0, 2}}) {
    if (!bending) break;
    modes.push_back({.freq_Hz = freq_Hz, .damping_ratio = kDamping, .order = order, .amplitude_per_sqrt_kg = 1.7});
  }
  int hoop_order = 0;
  for (const double freq_Hz : {1190.0, 1440.0, 1690.0, 1940.0, 2190.0}) {
    modes.push_back({.freq_Hz = freq_Hz,
                     .damping_ratio = 0.003,
                     .type = synth::SynthModeType::hoop,
                     .order = ++hoop_order,
                     .angle_rad = 12 * kDegree_rad,
                     .amplitude_per_sqrt_kg = 2.7});
  }
  synth::SynthSpec spec = test::bat_spec(modes, 1);
  spec.points = {{.angle_rad = 0}};
  spec.sensors = {{.angle_rad = 0}, {.angle_rad = std::numbers::pi / 2}, {.angle_rad = third_rad}};
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return spec;
}

// The third sensor, across the blow, shows hoop modes alone. They move the places at 0° and 90° against each other.
TEST(ChannelFindings, DoNotTakeHoopModesAtAnUnknownAngleForAReversedSensor) {
  acquire::Record record = synth::synthesise(bat_with_three_sensors(true, std::numbers::pi / 2)).record;
  record.accel[2].angle_rad.reset();
  const Analysis analysis(record, kBand);
  EXPECT_THAT(warnings_of(analysis), Not(Contains(StartsWith("reversed"))));
  const auto& pairs = analysis.channel_findings().pairs;
  const auto third = std::find_if(pairs.begin(), pairs.end(), [](const ChannelPair& pair) { return pair.second == 2; });
  ASSERT_NE(third, pairs.end());
  EXPECT_LT(third->correlation, -0.95);
  EXPECT_EQ(third->modes, (std::vector<std::size_t>{2, 3, 4, 5, 6}));
}

// Bending and hoop modes agree, and so do hoop modes at one stated angle.
TEST(ChannelFindings, NameTheReversedOneOfThreeSensors) {
  for (const bool bending : {true, false}) {
    synth::SynthSpec spec = bat_with_three_sensors(bending, 0);
    spec.sensors[2].sign = -1;
    acquire::Record record = synth::synthesise(spec).record;
    if (bending) record.accel[2].angle_rad.reset();
    EXPECT_THAT(warnings_of(Analysis(record, kBand)), Contains(StartsWith("reversed: "))) << bending;
  }
}

TEST(ChannelFindings, NameUnitsThatDiffer) {
  synth::SynthSpec oblique = bat_in_line();
  for (std::size_t m = 0; m < 3; ++m) oblique.modes[m].angle_rad = 30 * kDegree_rad;
  const acquire::Record good = synth::synthesise(oblique).record;
  const auto scaled = [&](double first, double second) {
    return test::with_changed_accel(good, [=](std::size_t, std::size_t channel, std::vector<double>& x) {
      for (double& sample : x) sample *= channel == 0 ? first : second;
    });
  };
  const auto millimetres = warnings_of(Analysis(scaled(1, 1000), kBand));
  EXPECT_THAT(millimetres, Contains(StartsWith("units_differ: ")));
  EXPECT_THAT(millimetres, Not(Contains(StartsWith("implausible"))));
  EXPECT_THAT(warnings_of(Analysis(scaled(0.001, 1), kBand)), Contains(StartsWith("units_differ: ")));
  EXPECT_THAT(warnings_of(Analysis(scaled(2e4, 2e4), kBand)), Contains(StartsWith("implausible_motion: ")));
}

TEST(ChannelFindings, NameAReversedSensorAndOneThatRepeatsAnother) {
  acquire::Record good = synth::synthesise(oblique_bat()).record;
  const auto twin = [&](double sign) {
    acquire::Record out = good;
    out.contiguous.clear();
    out.read_accel_mps2 = [read = good.read_accel_mps2, sign](std::size_t row, std::size_t channel, std::size_t first,
                                                              std::span<double> to) {
      read(row, 0, first, to);
      for (double& x : to) x *= channel == 0 ? 1 : sign;
    };
    return out;
  };
  EXPECT_THAT(warnings_of(Analysis(twin(1), kBand)),
              Contains(AllOf(StartsWith("same_motion: "), HasSubstr("So do bending modes alone"))));
  // Sensors at right angles move in opposite phase in every mode if the hits are halfway between one sensor and the
  // place opposite the other.
  EXPECT_THAT(warnings_of(Analysis(twin(-1), kBand)),
              AllOf(Contains(StartsWith("midway_hit: ")), Not(Contains(StartsWith("reversed")))));
  good.accel[1].angle_rad = good.accel[0].angle_rad;
  EXPECT_THAT(warnings_of(Analysis(twin(-1), kBand)), Contains(StartsWith("reversed: ")));
}

// Bending in one plane moves two sensors by one ratio, the tangent of the plane's angle: no fault of the sensors.
TEST(ChannelFindings, DoNotTakeASensorNearlyAcrossTheBlowForARepeatedSignal) {
  synth::SynthSpec spec = oblique_bat();
  for (synth::SynthMode& mode : spec.modes) mode.angle_rad = 3 * kDegree_rad;
  const Analysis analysis(synth::synthesise(spec).record, kBand);
  EXPECT_THAT(warnings_of(analysis), Not(Contains(StartsWith("same_motion: "))));
  ASSERT_EQ(analysis.channel_findings().pairs.size(), 1U);
  EXPECT_NEAR(analysis.channel_findings().pairs[0].ratio, std::tan(3 * kDegree_rad), 1e-3);
}

}  // namespace percuss::pipeline::channel_findings_test
