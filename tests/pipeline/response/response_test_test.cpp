#include "pipeline/response/response_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "acquire/channels/unit_notes.hpp"
#include "core/units.hpp"
#include "pipeline/response/missing_results.hpp"
#include "support/response_records.hpp"

namespace percuss::pipeline::response_test_test {

constexpr double kFs_Hz = 8192, kPulse_s = 0.002;

struct TrueMode {
  identify::Pole pole;
  std::vector<double> shape;  // [channels]
};
const std::vector<TrueMode> kModes{{{169, 0.010}, {1, 0.47}}, {{597, 0.008}, {1, -0.6}}, {{1820, 0.006}, {-0.8, 0.9}}};

// The response of modes with real shapes to a half sine from `onset_s` on, by the closed form of each convolution.
void add_hit(double onset_s, double scale, std::vector<std::vector<double>>& accel) {
  const double p = std::numbers::pi / kPulse_s;
  for (const TrueMode& mode : kModes) {
    const Complex s = identify::decay_rate_of(mode.pole).rate_radps;
    const double omega_d = s.imag();
    // ∫ sin(pτ) exp(s(t − τ)) dτ from 0 to t, but not beyond the pulse's end
    const auto response = [&](double t) {
      if (t <= 0) return 0.0;
      const double end = std::min(t, kPulse_s);
      const Complex factor = std::exp(s * t) / (s * s + p * p);
      const Complex integral = factor * (p - std::exp(-s * end) * (p * std::cos(p * end) + s * std::sin(p * end)));
      // Acceleration of x'' + 2ζωx' + ω²x = F: F + Im(s² e^{st} …)/ω_d
      return (s * s * integral).imag() / omega_d + (t < kPulse_s ? std::sin(p * t) : 0);
    };
    for (std::size_t c = 0; c < accel.size(); ++c) {
      for (std::size_t n = 0; n < accel[c].size(); ++n)
        accel[c][n] += scale * mode.shape[c] * response(static_cast<double>(n) / kFs_Hz - onset_s);
    }
  }
}

acquire::Record rows(double noise) {
  std::vector<std::vector<std::vector<double>>> accel;
  for (const double scale : {100.0, 70.0, -120.0}) {
    add_hit(0.05 + 1e-5 * scale, scale, accel.emplace_back(2, std::vector<double>(8192)));
  }
  return test::response_record(kFs_Hz, std::move(accel), noise, false);
}

TEST(ResponseTest, IsExactWithoutNoise) {
  constexpr double kExact = 1e-10;  // relative: rounding; measured 7e-15
  // The amplitude of a hit is its value at the first sample of the decay. The time of this sample after the onset
  // differs by up to one sample between hits. No mode decays by more than 1 % within a sample.
  constexpr double kOneSample = 0.01;
  const ResponseTest test = analyse_responses(rows(0), {});
  ASSERT_EQ(test.hits.size(), 3U);
  ASSERT_EQ(test.found.modes.size(), kModes.size());
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    const identify::Mode& mode = test.found.modes[m].mode;
    EXPECT_NEAR(mode.pole.freq_Hz, kModes[m].pole.freq_Hz, kExact * mode.pole.freq_Hz);
    EXPECT_NEAR(mode.pole.damping_ratio, kModes[m].pole.damping_ratio, kExact);
    const std::size_t ref = test.found.reference, other = 1 - ref;
    EXPECT_NEAR(mode.residues[other].value.real(), kModes[m].shape[other] / kModes[m].shape[ref], kExact);
    EXPECT_NEAR(mode.residues[other].value.imag(), 0, kExact);
    ASSERT_EQ(test.found.modes[m].hits.size(), 3U);
    // The amplitudes of the hits are in the ratio of their forces.
    EXPECT_NEAR(std::abs(test.found.modes[m].hits[1].value / test.found.modes[m].hits[0].value), 0.7, kOneSample);
  }
  // The fit begins after the pulse, and soon after it.
  EXPECT_GE(test.start_s, 0.8 * kPulse_s);
  EXPECT_LE(test.start_s, 3 * kPulse_s);
}

TEST(ResponseTest, StatesTrueStandardDeviationsInNoise) {
  const ResponseTest test = analyse_responses(rows(2), {});
  ASSERT_EQ(test.found.modes.size(), kModes.size());
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    const identify::Mode& mode = test.found.modes[m].mode;
    EXPECT_NEAR(mode.pole.freq_Hz, kModes[m].pole.freq_Hz, 4 * mode.freq_std_Hz);
    EXPECT_NEAR(mode.pole.damping_ratio, kModes[m].pole.damping_ratio, 4 * mode.damping_std);
    EXPECT_LT(mode.freq_std_Hz, 1e-3 * mode.pole.freq_Hz);
  }
}

const Warning* warning_of(const ResponseTest& test, const std::string& code) {
  const auto found = std::find_if(test.warnings.begin(), test.warnings.end(),
                                  [&](const Warning& warning) { return warning.code == code; });
  return found == test.warnings.end() ? nullptr : &*found;
}

// One long row with several hits, as an audio recorder writes it.
TEST(ResponseTest, FindsTheHitsOfAContinuousRecord) {
  const std::vector<double> onsets_s{0.3, 1.4, 2.2};
  std::vector<std::vector<double>> channels(2, std::vector<double>(static_cast<std::size_t>(3.5 * kFs_Hz)));
  for (const double onset_s : onsets_s) add_hit(onset_s, 100, channels);
  const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {channels}, 0.05, true), {});
  ASSERT_EQ(test.hits.size(), onsets_s.size());
  for (std::size_t h = 0; h < onsets_s.size(); ++h) EXPECT_NEAR(test.hits[h].onset_s, onsets_s[h], 0.5e-3);
  EXPECT_EQ(test.found.modes.size(), kModes.size());
}

// Two equal shapes within half a bandwidth, and one mode whose frequency differs between two hits, look alike. Most of
// the pairs that count as one mode get the warning. In the other ones, the second mode counts as misfit of the first,
// without a warning. Rounding may decide between the two cases.
TEST(ResponseTest, SaysWhereItCannotTellAPairFromScatter) {
  const auto warned = [](const ResponseTest& test) { return warning_of(test, "pair_or_scatter") != nullptr; };
  constexpr double kDamping = 0.01, kFreq_Hz = 500;  // half-power bandwidth 10 Hz
  const auto test_of = [&](double apart_Hz, double scatter_Hz, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<std::vector<std::vector<double>>> accel;
    for (int h = 0; h < 2; ++h) {
      std::vector<double>& x = accel.emplace_back(1, std::vector<double>(8192)).front();
      for (const double from_Hz : {0.0, apart_Hz}) {
        const Complex s = identify::decay_rate_of({kFreq_Hz + from_Hz + scatter_Hz * h, kDamping}).rate_radps;
        const Complex a = 100.0 * Complex(gauss(random), gauss(random));
        for (std::size_t n = 512; n < x.size(); ++n)
          x[n] += (a * std::exp(s * (static_cast<double>(n - 512) / kFs_Hz))).real();
        if (apart_Hz == 0) break;
      }
    }
    return analyse_responses(test::response_record(kFs_Hz, std::move(accel), 0.5, false), {});
  };
  int merged = 0, silent = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const ResponseTest pair = test_of(4, 0, seed);
    if (pair.found.modes.size() > 1) continue;
    ++merged;
    silent += warned(pair) ? 0 : 1;
  }
  EXPECT_GE(merged, 2);  // without pairs that count as one mode, the next check would test nothing
  EXPECT_LT(2 * silent, merged) << merged;
  const ResponseTest scattering = test_of(0, 2, 1);
  EXPECT_EQ(scattering.found.modes.size(), 1U);
  EXPECT_TRUE(warned(scattering));
  EXPECT_FALSE(warned(test_of(0, 0, 1)));
}

TEST(ResponseTest, ObeysTheUser) {
  AnalysisOptions options;
  options.reject_hits = {1};
  options.band_Hz = {100, 1000};
  const ResponseTest test = analyse_responses(rows(1), options);
  EXPECT_FALSE(test.hits[1].accepted);
  EXPECT_TRUE(test.hits[1].by_user);
  ASSERT_EQ(test.found.modes.size(), 2U);
  EXPECT_EQ(test.found.modes[0].hits.size(), 2U);
  options.modes.modes = 1;
  EXPECT_EQ(analyse_responses(rows(1), options).found.modes.size(), 1U);
}

// Modes beyond the band are as strong as those within it. Their flanks must not count as noise.
TEST(ResponseTest, FindsNoFalseModesBesideStrongOnesBeyondTheBand) {
  const std::vector<double> freqs_Hz{30, 167, 197.3, 365.1, 573.6, 797.8, 1103.9, 1224.5, 1782.1, 1972.2, 2389};
  constexpr std::pair<double, double> kBand_Hz{100, 700};
  constexpr std::size_t kWithin = 4;  // modes
  constexpr double kDamping = 0.003;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<std::vector<double>> shapes;
    for (std::size_t m = 0; m < freqs_Hz.size(); ++m) shapes.push_back({gauss(random), gauss(random), gauss(random)});
    std::vector<std::vector<std::vector<double>>> accel;
    for (int h = 0; h < 4; ++h) {
      auto& channels = accel.emplace_back(3, std::vector<double>(16384));
      for (std::size_t m = 0; m < freqs_Hz.size(); ++m) {
        const Complex s = identify::decay_rate_of({freqs_Hz[m], kDamping}).rate_radps;
        const double amplitude = 100 * gauss(random);
        for (std::size_t n = 512; n < 16384; ++n) {
          const double x = amplitude * std::exp(s * (static_cast<double>(n - 512) / kFs_Hz)).real();
          for (std::size_t c = 0; c < 3; ++c) channels[c][n] += shapes[m][c] * x;
        }
      }
    }
    AnalysisOptions options;
    options.band_Hz = kBand_Hz;
    const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, std::move(accel), 0.1, false), options);
    EXPECT_EQ(test.band_Hz, kBand_Hz);
    EXPECT_TRUE(test.found.tones.empty());
    for (const identify::DecayMode& one : test.found.modes) {
      const auto nearest = std::min_element(freqs_Hz.begin(), freqs_Hz.end(), [&](double a, double b) {
        return std::abs(a - one.mode.pole.freq_Hz) < std::abs(b - one.mode.pole.freq_Hz);
      });
      EXPECT_NEAR(one.mode.pole.freq_Hz, *nearest, 4 * one.mode.freq_std_Hz);
      EXPECT_NEAR(one.mode.pole.damping_ratio, kDamping, 4 * one.mode.damping_std);
      EXPECT_LT(one.mode.freq_std_Hz, 1e-5 * *nearest);
    }
    EXPECT_EQ(test.found.modes.size(), kWithin);
  }
}

TEST(ResponseTest, EndsWhenItsBudgetIsSpent) {
  AnalysisOptions options;
  options.budget = Budget{.time_s = 1e-6};
  EXPECT_THROW(analyse_responses(rows(1), options), BudgetSpent);
}

// In one spectrum, nothing distinguishes a weak close mode from a frequency that changes while the amplitude decays.
// Here the frequency rises by a quarter of the half-power bandwidth from the first sample to the last.
TEST(ResponseTest, TakesAFrequencyThatChangesDuringTheDecayForOneMode) {
  constexpr double kFreq_Hz = 400, kDamping = 0.003, kRise = 0.25 * 2 * kDamping, kNoise = 0.01;
  const double decay_per_s = kTwoPi * kFreq_Hz * kDamping;
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  std::vector<double> x(16384);
  double phase = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t_s = static_cast<double>(n) / kFs_Hz - 0.05;
    x[n] = kNoise * gauss(random);
    if (t_s < 0) continue;
    const double amplitude = std::exp(-decay_per_s * t_s);
    phase += kTwoPi * kFreq_Hz * (1 + kRise * (1 - amplitude * amplitude)) / kFs_Hz;
    x[n] += 100 * amplitude * std::sin(phase);
  }
  const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {{x}}, 0, true), {});
  ASSERT_EQ(test.found.modes.size(), 1U);
  const identify::Mode& mode = test.found.modes[0].mode;
  // The part "noise" of the ± is estimated from the residual, which is nearly all misfit here. This part is therefore
  // too large, and the part "misfit" is of the same size.
  EXPECT_GT(mode.freq_std_parts_Hz.misfit, 0.5 * mode.freq_std_parts_Hz.noise);
  // In the range of the frequency, or as near to it as its own ± says: rounding decides which of two fits is kept.
  constexpr double kMiddle_Hz = kFreq_Hz * (1 + kRise / 2), kHalf_Hz = kFreq_Hz * kRise / 2;
  EXPECT_LT(std::abs(mode.pole.freq_Hz - kMiddle_Hz), kHalf_Hz + 3 * mode.freq_std_Hz);
}

// One microphone and a mode whose frequency falls with its amplitude, in one blow and in two of different strength.
TEST(ResponseTest, GathersTheDecaysOfAFrequencyThatFollowsTheAmplitude) {
  constexpr double kFreq_Hz = 400, kDamping = 0.003, kSoftening = 0.00375, kNoise = 0.01;
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  const auto microphone = [&](double strength) {
    std::vector<double> x(16384);
    double phase = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      const double t_s = static_cast<double>(n) / kFs_Hz - 0.05;
      x[n] = kNoise * gauss(random);
      if (t_s < 0) continue;
      const double amplitude = strength * std::exp(-kTwoPi * kFreq_Hz * kDamping * t_s);
      phase += kTwoPi * kFreq_Hz * (1 - kSoftening * amplitude) / kFs_Hz;
      x[n] += 100 * amplitude * std::sin(phase);
    }
    return x;
  };
  const std::vector<std::vector<std::vector<double>>> blow{{microphone(1)}}, blows{{microphone(1)}, {microphone(0.6)}};
  for (const auto& rows : {blow, blows}) {
    const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, rows, 0, false), {});
    ASSERT_EQ(test.found.modes.size(), 1U);
    const identify::Mode& mode = test.found.modes[0].mode;
    EXPECT_GT(mode.pole.freq_Hz, kFreq_Hz * (1 - kSoftening));
    EXPECT_LT(std::abs(mode.pole.freq_Hz - kFreq_Hz), 3 * mode.freq_std_Hz);
    EXPECT_THAT(test.warnings, testing::Contains(testing::Field(&Warning::code, "uneven_decay")));
  }
}

// One microphone. Two modes within a bandwidth, and three beyond it, are no uneven decay.
TEST(ResponseTest, TakesPairsAndChordsOfOneMicrophoneForModes) {
  const auto modes_in = [](const std::vector<double>& freqs_Hz) {
    constexpr double kDamping = 0.003;
    std::mt19937 random(6);
    std::normal_distribution<double> gauss;
    std::vector<double> x(16384);
    for (std::size_t n = 0; n < x.size(); ++n) {
      const double t_s = static_cast<double>(n) / kFs_Hz - 0.05;
      x[n] = 0.01 * gauss(random);
      if (t_s < 0) continue;
      double share = 60;
      for (const double freq_Hz : freqs_Hz) {
        x[n] += share * std::exp(-kTwoPi * freq_Hz * kDamping * t_s) * std::sin(kTwoPi * freq_Hz * t_s + share);
        share *= 0.7;
      }
    }
    const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {{x}}, 0, false), {});
    EXPECT_THAT(test.warnings, testing::Not(testing::Contains(testing::Field(&Warning::code, "uneven_decay"))));
    return test.found.modes.size();
  };
  EXPECT_EQ(modes_in({400, 401.5}), 2U);
  EXPECT_EQ(modes_in({400, 405, 410}), 3U);
}

TEST(ResponseTest, SaysWhatNeedsAForce) {
  const ResponseTest test = analyse_responses(rows(1), {});
  const Warning* const found = warning_of(test, "no_force");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->message, testing::HasSubstr("1/kg"));
}

TEST(ResponseTest, NamesAHammerAmongTheResponses) {
  EXPECT_EQ(warning_of(analyse_responses(rows(1), {}), "hammer_as_response"), nullptr);
  std::vector<std::vector<std::vector<double>>> signals;
  for (const double scale : {100.0, 70.0, -120.0}) {
    add_hit(0.05 + 1e-5 * scale, scale, signals.emplace_back(2, std::vector<double>(8192)));
    std::vector<double> force(8192);
    for (std::size_t n = 0; n < force.size(); ++n) {
      const double t = static_cast<double>(n) / kFs_Hz - 0.05;
      if (t > 0 && t < kPulse_s) force[n] = std::abs(scale) * std::sin(std::numbers::pi * t / kPulse_s);
    }
    signals.back().push_back(std::move(force));
  }
  EXPECT_NE(warning_of(analyse_responses(test::response_record(kFs_Hz, std::move(signals), 0.01, false), {}),
                       "hammer_as_response"),
            nullptr);
}

acquire::Record noise() {
  return test::response_record(kFs_Hz, {{std::vector<double>(4096), std::vector<double>(4096)}}, 1, false);
}

// A recording without a blow is no test.
TEST(ResponseTest, FindsNoImpactInNoise) {
  const ResponseTest test = analyse_responses(noise(), {});
  EXPECT_TRUE(test.found.modes.empty());
  EXPECT_FALSE(test.possible());
  EXPECT_EQ(count_impacts(test), 0U);
  ASSERT_EQ(test.hits.size(), 1U);
  EXPECT_FALSE(test.hits[0].accepted);
  ASSERT_NE(warning_of(test, "no_modes"), nullptr);
  EXPECT_THAT(warning_of(test, "no_modes")->message,
              testing::HasSubstr("no impact was found: no signal rises above the noise"));
  EXPECT_EQ(why_impossible(test).text, warning_of(test, "no_modes")->message);
  EXPECT_EQ(warning_of(test, "no_free_decay"), nullptr);
}

TEST(ResponseTest, UsesNoiseThatTheUserAccepts) {
  AnalysisOptions options;
  options.accept_hits = {0};
  const ResponseTest test = analyse_responses(noise(), options);
  EXPECT_TRUE(test.possible());
  EXPECT_TRUE(test.hits[0].accepted);
  ASSERT_NE(warning_of(test, "no_modes"), nullptr);
}

TEST(ResponseTest, SaysWhereTheBandHoldsNoMode) {
  AnalysisOptions options;
  options.band_Hz = {2500, 3000};
  const ResponseTest test = analyse_responses(rows(1), options);
  EXPECT_TRUE(test.possible());
  EXPECT_EQ(count_impacts(test), 3U);
  ASSERT_NE(warning_of(test, "no_modes"), nullptr);
  EXPECT_THAT(warning_of(test, "no_modes")->message, testing::HasSubstr("no mode was found from 2500 to 3000 Hz"));
  EXPECT_EQ(warning_of(analyse_responses(rows(1), {}), "no_modes"), nullptr);
}

// The row is cut after the blow: no impact rises in it, but its modes decay.
TEST(ResponseTest, TakesARowThatBeginsWithinADecay) {
  std::vector<std::vector<double>> channels(2, std::vector<double>(8192));
  add_hit(0.01, 100, channels);
  for (std::vector<double>& channel : channels) channel.erase(channel.begin(), channel.begin() + 1000);
  const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {channels}, 0.1, false), {});
  ASSERT_EQ(test.hits.size(), 1U);
  EXPECT_FALSE(test.hits[0].impact.whole_pulse);
  EXPECT_TRUE(test.hits[0].accepted);
  EXPECT_FALSE(test.found.modes.empty());
  EXPECT_EQ(count_impacts(test), 1U);
}

TEST(ResponseTest, NamesConstantChannels) {
  const ResponseTest test =
      analyse_responses(test::response_record(kFs_Hz, {{std::vector<double>(4096, 3.5)}}, 0, false), {});
  EXPECT_FALSE(test.possible());
  EXPECT_TRUE(test.hits.empty());
  ASSERT_NE(warning_of(test, "dead_channel"), nullptr);
  EXPECT_THAT(warning_of(test, "dead_channel")->message, testing::HasSubstr("is constant"));
  EXPECT_EQ(warning_of(test, "no_free_decay"), nullptr);
  EXPECT_EQ(why_impossible(test).text, warning_of(test, "dead_channel")->message);
  // Of two channels, the other one is analysed.
  std::vector<std::vector<double>> channels(2, std::vector<double>(8192));
  add_hit(0.1, 100, channels);
  channels[1].assign(8192, 0.0);
  const ResponseTest other = analyse_responses(test::response_record(kFs_Hz, {channels}, 0, false), {});
  ASSERT_NE(warning_of(other, "dead_channel"), nullptr);
  EXPECT_EQ(warning_of(other, "dead_channel")->options, std::vector<OptionId>{"accel_channel"});
  EXPECT_FALSE(other.found.modes.empty());
}

TEST(ResponseTest, MayGradeTheHitsAlone) {
  const ResponseTest hits = analyse_responses(rows(1), {}, ResponseWork::hits), modes = analyse_responses(rows(1), {});
  EXPECT_FALSE(hits.fitted);
  EXPECT_TRUE(hits.possible());
  EXPECT_TRUE(hits.found.modes.empty());
  EXPECT_EQ(warning_of(hits, "no_modes"), nullptr);
  ASSERT_EQ(hits.hits.size(), modes.hits.size());
  for (std::size_t h = 0; h < hits.hits.size(); ++h) {
    EXPECT_EQ(hits.hits[h].onset_s, modes.hits[h].onset_s);
    EXPECT_EQ(hits.hits[h].accepted, modes.hits[h].accepted);
  }
}

// Frequencies and damping ratios need no unit: one remark replaces the reader's notes.
TEST(ResponseTest, AsksForNoUnitThatNoResultNeeds) {
  acquire::Record record = rows(1);
  record.accel[0].name = record.accel[1].name = "channel";
  for (acquire::SignalInfo& signal : record.accel) {
    signal.unit = "m/s^2";
    signal.unit_assumed = true;
  }
  record.notes = {{"another note", {"unit"}}, acquire::full_scale_note()};
  acquire::note_assumed_units(record);
  std::vector<std::string> said;
  for (const Warning& warning : analyse_responses(record, {}).warnings) {
    if (warning.code == "input") said.push_back(warning.message);
  }
  EXPECT_THAT(said, testing::ElementsAre("another note", testing::StartsWith("no unit is stated, so amplitudes are")));
}

TEST(ResponseTest, NamesTheOptionsThatNeedAForce) {
  EXPECT_TRUE(stated_force_options({}).empty());
  AnalysisOptions options;
  options.estimator = frf::Estimator::hv;
  options.exponential_end = 0.01;
  options.delays.automatic = true;
  options.hits.trigger_N = 5;
  EXPECT_EQ(stated_force_options(options), (std::vector<OptionId>{"estimator", "exponential", "delay", "trigger"}));
}

// Two microphones are no accelerometers on a tube.
TEST(ResponseTest, AssumesNoAnglesOfPressures) {
  EXPECT_TRUE(analyse_responses(rows(1), {}).options.classes.angles_assumed);
  acquire::Record record = rows(1);
  for (acquire::SignalInfo& signal : record.accel) signal.measures = Quantity::pressure;
  const ResponseTest test = analyse_responses(record, {});
  EXPECT_FALSE(test.options.classes.angles_assumed);
  EXPECT_FALSE(test.record.accel[0].angle_rad.has_value());
  for (const identify::ModeClassification& one : test.classifications) EXPECT_FALSE(one.ratio.has_value());
}

}  // namespace percuss::pipeline::response_test_test
