#include "pipeline/warnings/record_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/units.hpp"
#include "pipeline/analysis.hpp"
#include "support/changed_record.hpp"
#include "support/force_row.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::record_findings_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t kDecay = 1300;  // a sample of each row, well within the decay
constexpr double kRate_Hz = 8192;

synth::SynthSpec tube(std::size_t hits = 5) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                      {.freq_Hz = 1900,
                       .damping_ratio = 0.004,
                       .type = synth::SynthModeType::hoop,
                       .order = 1,
                       .amplitude_per_sqrt_kg = 2.4}},
                     1);
  spec.hits = hits;
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

AnalysisOptions band() { return {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1}; }

std::vector<std::string> codes_of(const Analysis& analysis) {
  analysis.modes();
  return test::codes_of(analysis.warnings());
}

/// Both modes and no others, within five of their standard deviations.
void expect_true_modes(const Analysis& analysis) {
  const std::vector<identify::Mode>& modes = analysis.modes();
  ASSERT_EQ(modes.size(), 2U);
  const auto near = [](double value, double truth, double std) { EXPECT_LT(std::abs(value - truth), 5 * std); };
  near(modes[0].pole.freq_Hz, 200, modes[0].freq_std_Hz);
  near(modes[0].pole.damping_ratio, 0.02, modes[0].damping_std);
  near(modes[1].pole.freq_Hz, 1900, modes[1].freq_std_Hz);
  near(modes[1].pole.damping_ratio, 0.004, modes[1].damping_std);
}

TEST(RecordFindings, AreNoneForAGoodTest) {
  EXPECT_THAT(codes_of(Analysis(synth::synthesise(tube()).record, band())), IsEmpty());
}

class MissingSamples : public testing::TestWithParam<std::size_t> {};

TEST_P(MissingSamples, AreNamedAndPredicted) {
  const std::size_t count = GetParam();
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record,
                                                   [count](std::size_t row, std::size_t, std::vector<double>& x) {
                                                     const auto at =
                                                         x.begin() + static_cast<std::ptrdiff_t>(kDecay + 100 * row);
                                                     std::move(at + static_cast<std::ptrdiff_t>(count), x.end(), at);
                                                   }),
                          band());
  EXPECT_THAT(codes_of(analysis), Contains("lost_samples"));
  expect_true_modes(analysis);
}

INSTANTIATE_TEST_SUITE_P(RecordFindings, MissingSamples, testing::Values(1, 3, 16));

class Dropout : public testing::TestWithParam<std::size_t> {};

TEST_P(Dropout, IsNamedAndReplaced) {
  const std::size_t count = GetParam();
  const Analysis analysis(
      test::with_changed_accel(synth::synthesise(tube()).record,
                               [count](std::size_t row, std::size_t, std::vector<double>& x) {
                                 std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(kDecay + 77 * row), count, 0.0);
                               }),
      band());
  EXPECT_THAT(codes_of(analysis), Contains("dropout"));
  expect_true_modes(analysis);
}

INSTANTIATE_TEST_SUITE_P(RecordFindings, Dropout, testing::Values(1, 4, 32));

// The recorder's filter follows the amplifier, so that no two samples of a clipped top are equal.
TEST(RecordFindings, NameAnAmplifierThatClips) {
  const auto clip = [](std::size_t, std::size_t channel, std::vector<double>& x) {
    if (channel != 0) return;
    for (double& value : x) value = std::clamp(value, -300.0, 300.0);
    const std::vector<double> limited = x;
    for (std::size_t n = 1; n + 1 < x.size(); ++n) x[n] = 0.25 * (limited[n - 1] + limited[n + 1]) + 0.5 * limited[n];
  };
  AnalysisOptions options = band();
  options.modes.effort = identify::Effort::quick;  // the warning does not depend on the modes of the clipped signal
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record, clip), options);
  analysis.modes();
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
              Contains(AllOf(StartsWith("response_clipped: accel 1 ("), HasSubstr("its amplifier clips before"))));
}

// Flat tops at the recorder's limit are no fault of an amplifier. All clipped channels are named.
TEST(RecordFindings, NameARecorderThatClipsAllChannels) {
  const auto clip = [](std::size_t, std::size_t, std::vector<double>& x) {
    for (double& value : x) value = std::clamp(value, -300.0, 300.0);
  };
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record, clip), band());
  analysis.hits();
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
              Contains(StartsWith("response_clipped: the recorder clips accel 1 (300 m/s²), accel 2 (300 m/s²) in ")));
}

// The hits cannot be told to differ: their responses are noise.
TEST(RecordFindings, NameChannelsThatDoNotRespond) {
  const auto noise = [](std::size_t row, std::size_t channel, std::vector<double>& x) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(2 * row + channel));
    std::normal_distribution<double> normal;
    for (double& value : x) value = normal(random);
  };
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record, noise), band());
  EXPECT_THAT(codes_of(analysis), AllOf(Contains("dead_channel"), Not(Contains("hits_disagree"))));
  EXPECT_THAT(analysis.modes(), IsEmpty());
}

// A channel that does not respond: the extremes of its noise are nearly equal from hit to hit.
TEST(RecordFindings, NameNoClippingOfNoise) {
  const auto noise = [](std::size_t row, std::size_t channel, std::vector<double>& x) {
    if (channel != 1) return;
    std::mt19937 random(static_cast<std::mt19937::result_type>(row + 1));
    std::normal_distribution<double> normal;
    for (double& value : x) {
      do value = normal(random);
      while (std::abs(value) > 3.5);
    }
    const double extreme = 4 + 0.02 * static_cast<double>(row);  // extremes nearer to each other would be a limit
    x[kDecay] = extreme;
    x[kDecay + 1] = -0.98 * extreme;  // as would equal positive and negative extremes
  };
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record, noise), band());
  EXPECT_THAT(codes_of(analysis), Not(Contains("response_clipped")));
}

// Too many samples to be predicted: the hit is named.
TEST(RecordFindings, NameALongDropoutOfOneChannel) {
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record,
                                                   [](std::size_t row, std::size_t channel, std::vector<double>& x) {
                                                     if (row == 1 && channel == 1)
                                                       std::fill_n(x.begin() + kDecay, 400, 0.0);
                                                   }),
                          band());
  EXPECT_THAT(codes_of(analysis), Contains("dropout"));
  const auto warnings = analysis.warnings();
  const auto found =
      std::find_if(warnings.begin(), warnings.end(), [](const Warning& warning) { return warning.code == "dropout"; });
  ASSERT_NE(found, warnings.end());
  EXPECT_THAT(found->message, HasSubstr("drop out in hit 2 (400 samples, "));
  EXPECT_THAT(found->message, HasSubstr("reject these hits"));
  EXPECT_THAT(found->options, Contains("reject_hit"));
}

TEST(RecordFindings, RemoveHumThatDiffersInPhaseFromHitToHit) {
  const Analysis analysis(
      test::with_changed_accel(
          synth::synthesise(tube()).record,
          [](std::size_t row, std::size_t channel, std::vector<double>& x) {
            const double largest = *std::max_element(x.begin(), x.end());
            for (std::size_t n = 0; n < x.size(); ++n) {
              const double turns = 149.91 * static_cast<double>(n) / kRate_Hz + 0.37 * static_cast<double>(row * row);
              x[n] += 3e-3 * largest * std::cos(2 * std::numbers::pi * turns + static_cast<double>(channel));
            }
          }),
      band());
  EXPECT_THAT(codes_of(analysis), Contains("hum"));
  expect_true_modes(analysis);
}

TEST(RecordFindings, RemoveAHarmonicOfTheMainsWithEqualPhasesAtAllHits) {
  // The fundamental has another phase at each hit. The fifth harmonic alone looks like a mode without damping.
  const Analysis analysis(
      test::with_changed_accel(
          synth::synthesise(tube()).record,
          [](std::size_t row, std::size_t, std::vector<double>& x) {
            const double largest = *std::max_element(x.begin(), x.end());
            for (std::size_t n = 0; n < x.size(); ++n) {
              const double turns = 49.97 * static_cast<double>(n) / kRate_Hz;
              x[n] += 3e-3 * largest * std::cos(2 * std::numbers::pi * (turns + 0.37 * static_cast<double>(row * row)));
              x[n] += 1e-3 * largest * std::cos(2 * std::numbers::pi * 5 * turns);
            }
          }),
      band());
  EXPECT_THAT(codes_of(analysis), Contains("hum"));
  expect_true_modes(analysis);
}

TEST(RecordFindings, NameAnExponentialWindowByTheDecayOfTheNoise) {
  const double decay_per_s = 3;
  const Analysis analysis(test::with_changed_accel(synth::synthesise(tube()).record,
                                                   [&](std::size_t, std::size_t, std::vector<double>& x) {
                                                     for (std::size_t n = 0; n < x.size(); ++n)
                                                       x[n] *=
                                                           std::exp(-decay_per_s * static_cast<double>(n) / kRate_Hz);
                                                   }),
                          band());
  EXPECT_THAT(codes_of(analysis), Contains("already_windowed"));
  // What the message says to subtract leaves the true modes.
  const std::vector<identify::Mode>& modes = analysis.modes();
  ASSERT_EQ(modes.size(), 2U);
  const std::array freq_Hz{200.0, 1900.0}, damping{0.02, 0.004};
  for (std::size_t m = 0; m < 2; ++m) {
    const identify::Pole& pole = modes[m].pole;
    const double quotient = decay_per_s / kTwoPi / pole.freq_Hz, without = pole.damping_ratio - quotient;
    EXPECT_NEAR(without, damping[m], 5 * modes[m].damping_std);
    const double shift_Hz = pole.freq_Hz * quotient * (pole.damping_ratio + without) / 2;
    EXPECT_GT(shift_Hz, 5 * modes[m].freq_std_Hz);  // visible
    EXPECT_NEAR(pole.freq_Hz - shift_Hz, freq_Hz[m], 5 * modes[m].freq_std_Hz);
  }
}

TEST(RecordFindings, NameAnAcCoupledForce) {
  synth::SynthSpec spec = tube();
  spec.pretrigger_s = 0.05;  // for the level of the force at rest
  acquire::Record record = synth::synthesise(spec).record;
  record.read_force_N = [inner = record.read_force_N, rows = record.rows](std::size_t row, std::size_t first,
                                                                          std::span<double> out) {
    std::vector<double> x(rows[row].samples);
    inner(row, 0, x);
    constexpr double kCorner_Hz = 5;
    x = test::ac_coupled(x, kRate_Hz / (2 * std::numbers::pi * kCorner_Hz));
    std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  const Analysis analysis(record, band());
  EXPECT_THAT(codes_of(analysis), Contains("ac_coupling"));
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
              Contains(testing::HasSubstr("can be off by more than their ±; couple the channels by DC; or, if the "
                                          "accelerometers are coupled alike, use the force of all samples, whose noise "
                                          "makes every ± several times larger")));
}

TEST(RecordFindings, RemoveAZeroShiftAndASlope) {
  const acquire::Record good = synth::synthesise(tube()).record;
  const Analysis step(test::with_changed_accel(good,
                                               [](std::size_t, std::size_t, std::vector<double>& x) {
                                                 const auto peak = std::max_element(x.begin(), x.end());
                                                 const double size = 0.05 * *peak;
                                                 for (auto at = peak; at != x.end(); ++at)
                                                   *at += size *
                                                          std::exp(-static_cast<double>(at - peak) / (0.3 * kRate_Hz));
                                               }),
                      band());
  EXPECT_THAT(codes_of(step), Contains("zero_shift"));
  expect_true_modes(step);
  const Analysis slope(
      test::with_changed_accel(good,
                               [](std::size_t, std::size_t, std::vector<double>& x) {
                                 const double size = 0.06 * *std::max_element(x.begin(), x.end());
                                 for (std::size_t n = 0; n < x.size(); ++n)
                                   x[n] += size * (5 + static_cast<double>(n) / static_cast<double>(x.size()));
                               }),
      band());
  EXPECT_THAT(codes_of(slope), Contains("offset"));
  expect_true_modes(slope);
}

// Few samples before a hit hold no whole period of hum, so that hum has a mean there, but hardly a mean after the hit.
synth::SynthSpec short_before_hit() {
  synth::SynthSpec spec = tube();
  spec.pretrigger_s = 0.01;
  return spec;
}

/// Adds hum to a row, with another phase in each.
void add_hum(std::size_t row, double size, std::vector<double>& x) {
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] += size * std::sin(kTwoPi * 50 * static_cast<double>(n) / kRate_Hz + 1.3 * static_cast<double>(row));
}

TEST(RecordFindings, DoNotTakeHumForAZeroShift) {
  const acquire::Record good = synth::synthesise(short_before_hit()).record;
  for (const bool open : {true, false}) {
    const Analysis analysis(test::with_changed_accel(good,
                                                     [&](std::size_t row, std::size_t channel, std::vector<double>& x) {
                                                       if (channel != 1) return;
                                                       const double size = 0.1 * *std::max_element(x.begin(), x.end());
                                                       if (open) std::fill(x.begin(), x.end(), 0);
                                                       if (open) test::add_noise(x, 0.01 * size, row);
                                                       add_hum(row, size, x);
                                                     }),
                            band());
    EXPECT_THAT(codes_of(analysis), Contains("hum"));
    EXPECT_THAT(codes_of(analysis), Not(Contains("zero_shift"))) << (open ? "open cable" : "sensor");
  }
}

TEST(RecordFindings, NameAZeroShiftBesideHum) {
  const acquire::Record good = synth::synthesise(short_before_hit()).record;
  const Analysis analysis(
      test::with_changed_accel(good,
                               [](std::size_t row, std::size_t, std::vector<double>& x) {
                                 const auto peak = std::max_element(x.begin(), x.end());
                                 const double largest = *peak;
                                 for (auto at = peak; at != x.end(); ++at)
                                   *at += 0.05 * largest * std::exp(-static_cast<double>(at - peak) / (0.3 * kRate_Hz));
                                 add_hum(row, 0.1 * largest, x);
                               }),
      band());
  EXPECT_THAT(codes_of(analysis), AllOf(Contains("hum"), Contains("zero_shift")));
  expect_true_modes(analysis);
  EXPECT_LT(analysis.modes()[0].freq_std_Hz, 0.01) << "measured 0.0012; 0.08 where steps have the mean of the hum";
}

/// A record with a row more: the force of the last row once again, and its responses times `gain`.
acquire::Record with_copied_force(acquire::Record record, double gain) {
  const std::size_t last = record.rows.size() - 1;
  record.rows.push_back(record.rows.back());
  record.read_force_N = [last, inner = record.read_force_N](std::size_t row, std::size_t first, std::span<double> out) {
    inner(std::min(row, last), first, out);
  };
  record.read_accel_mps2 = [last, gain, inner = record.read_accel_mps2](std::size_t row, std::size_t channel,
                                                                        std::size_t first, std::span<double> out) {
    inner(std::min(row, last), channel, first, out);
    if (row <= last) return;
    for (double& x : out) x *= gain;
  };
  return record;
}

TEST(RecordFindings, NameRowsThatAreCopies) {
  const acquire::Record record = with_copied_force(synth::synthesise(tube(3)).record, 1);
  EXPECT_THAT(codes_of(Analysis(record, band())), Contains("duplicate"));
}

TEST(RecordFindings, DoNotTakeOneBlowAtSeveralPointsForCopies) {
  const acquire::Record record = with_copied_force(synth::synthesise(tube(3)).record, 0.9);
  EXPECT_THAT(codes_of(Analysis(record, band())), Not(Contains("duplicate")));
  // A copy of such a point is one all the same, and its original is the second hit with this force.
  const Analysis copied(with_copied_force(record, 1), band());
  copied.modes();
  EXPECT_THAT(test::lines_of_messages(copied.warnings()),
              Contains(AllOf(HasSubstr("duplicate: "), HasSubstr("of hits 4 and 5 are"))));
}

}  // namespace percuss::pipeline::record_findings_test
