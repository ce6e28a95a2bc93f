#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "acquire/channels/stored_frfs.hpp"
#include "core/units.hpp"
#include "pipeline/analysis.hpp"
#include "support/changed_record.hpp"
#include "support/force_row.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::warnings_test {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

AnalysisOptions band(double low_Hz = 60, double high_Hz = 3200) {
  return {.band_Hz = std::pair{low_Hz, high_Hz}, .threads = 1};
}

/// "code: message" of all warnings after the modes are classified.
std::vector<std::string> warnings_of(const acquire::Record& record, const AnalysisOptions& options = band()) {
  const Analysis analysis(record, options);
  if (!analysis.force_hits().empty() && analysis.possible()) analysis.classifications();
  return test::lines_of_messages(analysis.warnings());
}

/// The record with one channel of this constant value in the rows for which `dead` holds.
template <class Dead>
acquire::Record with_dead(acquire::Record record, std::size_t dead_channel, double value, Dead dead) {
  return test::with_changed_accel(
      std::move(record), [dead_channel, value, dead](std::size_t row, std::size_t channel, std::vector<double>& x) {
        if (channel == dead_channel && dead(row)) std::fill(x.begin(), x.end(), value);
      });
}

TEST(Warnings, AreNoneForAGoodTest) {
  EXPECT_THAT(warnings_of(synth::synthesise(test::bending_and_hoop_spec()).record), IsEmpty());
}

TEST(Warnings, RepeatTheNotesOfTheReader) {
  acquire::Record record = synth::synthesise(test::bending_and_hoop_spec()).record;
  record.notes = {"the unit of x is not stated"};
  EXPECT_THAT(warnings_of(record), Contains("input: the unit of x is not stated"));
}

TEST(Warnings, NameTheOptionOfTheirRemedy) {
  const acquire::Record record =
      with_dead(synth::synthesise(test::bending_and_hoop_spec()).record, 1, 0, [](std::size_t) { return true; });
  const Analysis analysis(record, band());
  analysis.hits();
  const std::vector<Warning> warnings = analysis.warnings();
  EXPECT_THAT(warnings, Contains(AllOf(Field(&Warning::code, "dead_channel"),
                                       Field(&Warning::options, ElementsAre("accel_channel")))));
}

TEST(Warnings, CountTheHitsNotUsed) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::missing}};
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record), Contains(HasSubstr("rejected_hits: 1 of 3 hits")));
}

// A broken cable: the second channel holds noise alone.
TEST(Warnings, NameAChannelThatShowsNoMode) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.modes.push_back({.freq_Hz = 700, .damping_ratio = 0.01, .order = 2, .amplitude_per_sqrt_kg = 1.7});
  const acquire::Record good = synth::synthesise(spec).record;
  const acquire::Record record =
      test::with_changed_accel(good, [](std::size_t row, std::size_t channel, std::vector<double>& x) {
        if (channel != 1) return;
        std::fill(x.begin(), x.end(), 0);
        test::add_noise(x, 0.1, row);
      });
  EXPECT_THAT(warnings_of(record), Contains(HasSubstr("dead_channel: accel 2 shows none of the ")));
  EXPECT_THAT(warnings_of(good), Not(Contains(HasSubstr("shows none"))));
}

/// The record of a tube whose second channel holds hum and noise, and no motion.
acquire::Record with_open_cable(double hum_mps2, double noise_mps2, std::size_t seed) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.modes.push_back({.freq_Hz = 700, .damping_ratio = 0.01, .order = 2, .amplitude_per_sqrt_kg = 1.7});
  const double turn = kTwoPi * 50 / spec.fs_Hz;
  return test::with_changed_accel(synth::synthesise(spec).record,
                                  [=](std::size_t row, std::size_t channel, std::vector<double>& x) {
                                    if (channel != 1) return;
                                    const double phase = static_cast<double>(7 * row + 3 * seed);
                                    for (std::size_t n = 0; n < x.size(); ++n)
                                      x[n] = hum_mps2 * std::sin(turn * static_cast<double>(n) + phase);
                                    test::add_noise(x, noise_mps2, 10 * seed + row);
                                  });
}

std::vector<identify::ModeType> types_of(const Analysis& analysis) {
  std::vector<identify::ModeType> out;
  for (const identify::ModeClassification& mode : analysis.classifications()) out.push_back(mode.type);
  return out;
}

// Hum has no zero mean over the short time before a hit, and is far larger than the noise that remains without it.
TEST(Warnings, NameAnOpenCableThatHums) {
  for (const double hum_mps2 : {3.0, 10.0}) {
    for (const std::size_t seed : {1U, 2U, 3U}) {
      const Analysis analysis(with_open_cable(hum_mps2, 0.05, seed), band());
      EXPECT_THAT(types_of(analysis), Each(identify::ModeType::unknown));
      EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
                  AllOf(Contains(AllOf(HasSubstr("dead_channel: accel 2 shows none of the "),
                                       HasSubstr("Mode types, which would rest on it, are not stated"))),
                        Not(Contains(HasSubstr("unexcited_channel"))), Not(Contains(HasSubstr("zero_shift")))))
          << hum_mps2 << " " << seed;
    }
  }
}

TEST(Warnings, StateNoTypesThatRestOnAConstantChannel) {
  const acquire::Record good = synth::synthesise(test::bending_and_hoop_spec()).record;
  const Analysis analysis(with_dead(good, 1, 0, [](std::size_t) { return true; }), band());
  EXPECT_THAT(types_of(analysis), AllOf(Not(IsEmpty()), Each(identify::ModeType::unknown)));
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()),
              Contains(AllOf(HasSubstr("dead_channel: accel 2 is constant in every accepted hit"),
                             HasSubstr("Mode types, which would rest on it, are not stated"))));
  EXPECT_THAT(types_of(Analysis(good, band())), Not(Contains(identify::ModeType::unknown)));
}

// A mode above the band belongs to the fit, so that a hump between two antiresonances of the band is no peak without a
// mode.
TEST(Warnings, NameNoHumpBesideAStrongModeAboveTheBand) {
  synth::SynthSpec spec = test::bat_spec({{.freq_Hz = 5.2, .damping_ratio = 0.05, .residue_per_kg = {0.29}},
                                          {.freq_Hz = 7.8, .damping_ratio = 0.06, .residue_per_kg = {-0.19}},
                                          {.freq_Hz = 822, .damping_ratio = 0.0031, .residue_per_kg = {0.9}},
                                          {.freq_Hz = 831.5, .damping_ratio = 0.0027, .residue_per_kg = {0.5}},
                                          {.freq_Hz = 1463, .damping_ratio = 0.0022, .residue_per_kg = {0.54}},
                                          {.freq_Hz = 2118, .damping_ratio = 0.0035, .residue_per_kg = {0.56}},
                                          {.freq_Hz = 2951, .damping_ratio = 0.0018, .residue_per_kg = {0.23}},
                                          {.freq_Hz = 3622, .damping_ratio = 0.004, .residue_per_kg = {-0.21}},
                                          {.freq_Hz = 5240, .damping_ratio = 0.0026, .residue_per_kg = {0.28}},
                                          {.freq_Hz = 7300, .damping_ratio = 0.003, .residue_per_kg = {0.81}}},
                                         1);
  spec.fs_Hz = 25600;
  spec.samples = 16384;
  spec.sensors = {{}};
  spec.pulse.width_s = 0.00019;
  spec.hits = 5;
  spec.noise = {.force = 7e-4, .accel = 2e-4};
  const Analysis analysis(synth::synthesise(spec).record, band(300, 6000));
  EXPECT_EQ(analysis.modes().size(), 7U);
  EXPECT_GT(analysis.lines().freq_Hz(analysis.lines().count - 1), 7300) << "otherwise this test shows nothing";
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()), Not(Contains(HasSubstr("unclaimed_peaks"))));
}

// A sensor across the blow sees no bending, but rings with the hoop mode above the band: it is not dead.
TEST(Warnings, DoNotSuspectASensorAcrossTheBlow) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  for (const auto& [freq_Hz, order] : {std::pair{600.0, 2}, std::pair{1200.0, 3}})
    spec.modes.push_back({.freq_Hz = freq_Hz, .damping_ratio = 0.005, .order = order, .amplitude_per_sqrt_kg = 1.7});
  spec.noise.accel = 1e-3;
  const auto warnings = warnings_of(synth::synthesise(spec).record, band(60, 1500));
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("unexcited_channel: accel 2 shows none of the 3 modes, although it "),
                                       HasSubstr("a sensor across the blow sees no bending mode"))));
  EXPECT_THAT(warnings, Not(Contains(HasSubstr("dead_channel"))));
}

// A loose cable at one point of a survey: the hits there do not disagree with the others, they show nothing.
TEST(Warnings, NameAPointAtWhichASensorShowsNothing) {
  constexpr int kPoint = 7;
  const acquire::Record good = synth::synthesise(synth::synth_preset("plate")).record;
  const acquire::Record record =
      test::with_changed_accel(good, [&](std::size_t row, std::size_t, std::vector<double>& x) {
        if (good.rows[row].point != kPoint) return;
        std::fill(x.begin(), x.end(), 0);
        test::add_noise(x, 0.1, row);
      });
  const AnalysisOptions options = band(50, 500);
  const std::vector<std::string> warnings = warnings_of(record, options);
  EXPECT_THAT(warnings,
              Contains(AllOf(HasSubstr("dead_channel: "), HasSubstr(" shows only noise at point 7 in hits "))));
  EXPECT_THAT(warnings, Not(Contains(HasSubstr("hits_disagree"))));
  EXPECT_THAT(warnings_of(good, options), Not(Contains(HasSubstr("shows only noise"))));
}

/// The FRF of one mode at 200 Hz, with this sign of its imaginary part.
acquire::FrfRecord one_mode_frf(double imaginary_sign) {
  acquire::StoredFrfs stored;
  stored.record.lines = {.fs_Hz = 1000, .samples = 2000, .first = 1, .count = 900};
  stored.record.accel.push_back({.name = "accel 1"});
  stored.frfs.push_back({.point = 0, .channel = 0});
  for (std::size_t k = 0; k < stored.record.lines.count; ++k) {
    const double ratio = stored.record.lines.freq_Hz(k) / 200;
    const Complex frf = ratio * ratio / Complex(ratio * ratio - 1, -0.02 * ratio);
    stored.frfs.back().value.emplace_back(frf.real(), imaginary_sign * frf.imag());
  }
  return acquire::to_accelerances(std::move(stored), {});
}

std::vector<std::string> warnings_of_frf(double imaginary_sign) {
  const Analysis analysis(one_mode_frf(imaginary_sign), band(100, 300));
  analysis.classifications();
  return test::lines_of_messages(analysis.warnings());
}

// Only the cause is named, not the peaks and poles that no mode of exp(+jωt) describes.
TEST(Warnings, NameFrfsOfReversedPhaseFirstAndAlone) {
  const std::vector<std::string> reversed = warnings_of_frf(-1);
  ASSERT_FALSE(reversed.empty());
  EXPECT_THAT(reversed.front(), testing::StartsWith("reversed_phase: the phase of the FRFs rises through the "));
  for (const char* consequence : {"no_modes: ", "unclaimed_peaks: ", "unmodelled_poles: ", "model_misfit: ",
                                  "phase rises through the resonances: "})
    EXPECT_THAT(reversed, Not(Contains(HasSubstr(consequence))));
  EXPECT_THAT(warnings_of_frf(1), Not(Contains(HasSubstr("reversed_phase"))));
}

/// The record with the responses at one point replaced by noise and a wave packet far above a band up to 500 Hz.
acquire::Record with_noise_in_the_band_at(const acquire::Record& record, int at_point) {
  return test::with_changed_accel(record, [&, at_point](std::size_t row, std::size_t, std::vector<double>& x) {
    if (record.rows[row].point != at_point) return;
    const double middle = 0.1 * static_cast<double>(x.size()), width = 40;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double distance = (static_cast<double>(i) - middle) / width;
      x[i] = 100 * std::exp(-distance * distance / 2) * std::cos(2.5 * static_cast<double>(i));
    }
    test::add_noise(x, 0.1, row);
  });
}

// A point on the node lines of all modes in the band: the sensor moves, but the band holds only noise of these hits.
TEST(Warnings, BlameNoOtherStructureForNoiseInTheBand) {
  constexpr int kPoint = 7;
  const acquire::Record good = synth::synthesise(synth::synth_preset("plate")).record;
  const AnalysisOptions options = band(50, 500);
  const Analysis analysis(with_noise_in_the_band_at(good, kPoint), options);
  const std::vector<AnalysedHit>& hits = analysis.hits();
  const auto is_unlike = [](const AnalysedHit& hit) {
    return hit.accepted && hit.point == kPoint &&
           acquire::has_finding(hit.hit.findings, acquire::FindingCode::low_coherence);
  };
  EXPECT_EQ(std::count_if(hits.begin(), hits.end(), is_unlike), 2) << "the finding stays";
  EXPECT_THAT(test::lines_of_messages(analysis.warnings()), Not(Contains(HasSubstr("hits_disagree"))));
}

// Of the two hits of a point, one struck another point.
TEST(Warnings, NameAHitAtAnotherPoint) {
  acquire::Record record = synth::synthesise(synth::synth_preset("plate")).record;
  const auto first =
      std::find_if(record.rows.begin(), record.rows.end(), [](const auto& row) { return row.point == 7; });
  const auto other =
      std::find_if(record.rows.begin(), record.rows.end(), [](const auto& row) { return row.point == 12; });
  first->point = 12;
  other->point = 7;
  EXPECT_THAT(warnings_of(record, band(50, 500)), Contains(HasSubstr("hits_disagree: ")));
}

// The decay of noise ends at once, which leaves few samples of the row.
TEST(Warnings, NameAChannelThatDoesNotRespondToASingleHit) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.hits = 1;
  const acquire::Record record = test::with_changed_accel(
      synth::synthesise(spec).record, [](std::size_t row, std::size_t channel, std::vector<double>& x) {
        std::fill(x.begin(), x.end(), 0);
        test::add_noise(x, 0.1, 2 * row + channel);
      });
  EXPECT_THAT(warnings_of(record), Contains(HasSubstr("dead_channel: accel 1 does not respond: ")));
}

/// The record with another scale of the force of one point.
acquire::Record with_force_at(acquire::Record record, int point, double factor) {
  record.contiguous.clear();
  record.read_force_N = [inner = record.read_force_N, rows = record.rows, point, factor](
                            std::size_t row, std::size_t first, std::span<double> out) {
    inner(row, first, out);
    if (rows[row].point != point) return;
    for (double& force : out) force *= factor;
  };
  return record;
}

TEST(Warnings, BeginWithAForceInAnotherUnit) {
  const acquire::Record good = synth::synthesise(synth::synth_preset("plate")).record;
  const AnalysisOptions options = band(50, 500);
  EXPECT_THAT(warnings_of(good, options), Not(Contains(HasSubstr("units_differ"))));
  const std::vector<std::string> warnings = warnings_of(with_force_at(good, 7, 1e-3), options);
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings.front(), HasSubstr("units_differ: the force of the hits at point 7 is about "));
}

// The hammer's amplifier was set to another gain at one point.
TEST(Warnings, NameAForceThatIsWrongByTenAtOnePoint) {
  const acquire::Record good = synth::synthesise(synth::synth_preset("plate")).record;
  const AnalysisOptions options = band(50, 500);
  for (const int point : {0, 7, 12}) {
    for (const double factor : {0.1, 10.0}) {
      EXPECT_THAT(warnings_of(with_force_at(good, point, factor), options),
                  Contains(HasSubstr("units_differ: the force of the hits at point " + std::to_string(point) + " is ")))
          << factor;
    }
    const acquire::Record soft =
        with_force_at(test::with_changed_accel(good,
                                               [&](std::size_t row, std::size_t, std::vector<double>& x) {
                                                 if (good.rows[row].point != point) return;
                                                 for (double& value : x) value *= 0.1;
                                               }),
                      point, 0.1);
    EXPECT_THAT(warnings_of(soft, options), Not(Contains(HasSubstr("units_differ")))) << point;
  }
}

TEST(Warnings, NameADeadChannel) {
  for (const double value : {0.0, 2.5}) {
    const acquire::Record record =
        with_dead(synth::synthesise(test::bending_and_hoop_spec()).record, 1, value, [](std::size_t) { return true; });
    const auto warnings = warnings_of(record);
    EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("dead_channel: accel 2 "), HasSubstr("every accepted hit"))));
    EXPECT_THAT(warnings, Not(Contains(HasSubstr("accel 1 "))));
  }
}

TEST(Warnings, NameCoarseQuantisation) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.noise = {};
  spec.recorder.bits = 10;
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record),
              Contains(HasSubstr("coarse_steps: accel 1 is quantised in steps of ")));
  spec.noise.accel = 0.05;
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record), Not(Contains(HasSubstr("coarse_steps"))));
}

TEST(Warnings, NameAPretriggerShorterThanTheFiltersRinging) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.onset_spread_s = 0;
  spec.pretrigger_s = 20 / spec.fs_Hz;
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record),
              Contains(HasSubstr("short_pretrigger: a record begins 20 samples")));
  spec.pretrigger_s = 60 / spec.fs_Hz;
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record), Not(Contains(HasSubstr("short_pretrigger"))));
}

TEST(Warnings, NameTheHitsInWhichAChannelIsDead) {
  const acquire::Record record = with_dead(synth::synthesise(test::bending_and_hoop_spec()).record, 0, 0,
                                           [](std::size_t row) { return row != 1; });
  EXPECT_THAT(warnings_of(record), Contains(AllOf(HasSubstr("dead_channel: accel 1 "), HasSubstr("hits 1, 3"))));
}

TEST(Warnings, DoNotMentionChannelsThatWereNotRead) {
  const acquire::Record record =
      with_dead(synth::synthesise(test::bending_and_hoop_spec()).record, 1, 0, [](std::size_t) { return true; });
  const Analysis analysis(record, band());
  analysis.force_hits();
  EXPECT_TRUE(analysis.warnings().empty());
}

TEST(Warnings, NameANegativeForce) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  for (std::size_t hit = 0; hit < spec.hits; ++hit)
    spec.faults.push_back({.hit = hit, .kind = synth::SynthFaultKind::reversed});
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record), Contains(HasSubstr("polarity: ")));
}

TEST(Warnings, NameAForceThatDoesNotReachTheEndOfTheBand) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.pulse.width_s = 1e-3;
  EXPECT_THAT(warnings_of(synth::synthesise(spec).record), Contains(HasSubstr("low_bandwidth: ")));
}

TEST(Warnings, NameModesThatRingWhenTheRecordEnds) {
  EXPECT_THAT(warnings_of(synth::synthesise(test::bending_and_hoop_spec(0.15)).record),
              Contains(AllOf(HasSubstr("truncated_decay: "), HasSubstr("200.0 Hz"), Not(HasSubstr("1900")))));
}

// Several hits in a row, of which the analysis uses the part above the noise. The lower mode ends in the noise.
TEST(Warnings, SayThatTheAnalysisEndsADecayInNoise) {
  synth::SynthSpec spec = test::bending_and_hoop_spec(20);
  spec.layout = synth::SynthLayout::continuous;
  spec.noise.accel = 0.1;
  const acquire::Record record = synth::synthesise(spec).record;
  EXPECT_THAT(warnings_of(record),
              Contains(AllOf(HasSubstr("truncated_decay: the analysis uses the first 0."),
                             HasSubstr(" s of each hit, of "), HasSubstr("200."), HasSubstr("; state a length of "))));
  AnalysisOptions whole = band();
  whole.hits.length_s = 4;
  EXPECT_THAT(warnings_of(record, whole), Not(Contains(HasSubstr("truncated_decay"))));
  const Analysis analysis(record, band());
  analysis.modes();
  EXPECT_THAT(analysis.warnings(), Contains(AllOf(Field(&Warning::code, "truncated_decay"),
                                                  Field(&Warning::options, ElementsAre("length")))));
}

TEST(Warnings, NameNoPeaksWhenTheUserChoseTheModes) {
  AnalysisOptions by_frequency = band(), by_number = band();
  by_frequency.modes.start_Hz = {200};
  by_number.modes.modes = 1;
  EXPECT_THAT(warnings_of(synth::synthesise(test::bending_and_hoop_spec()).record, by_frequency), IsEmpty());
  EXPECT_THAT(warnings_of(synth::synthesise(test::bending_and_hoop_spec()).record, by_number), IsEmpty());
}

TEST(Warnings, StateTheSeparationOfVeryClosePairs) {
  synth::SynthSpec spec = test::bending_and_hoop_spec(40);
  spec.modes = {spec.modes[1], spec.modes[1]};
  spec.modes[0].freq_Hz = 500;
  spec.modes[1].freq_Hz = 500.04;
  for (synth::SynthMode& mode : spec.modes) mode.damping_ratio = 2e-5;
  spec.modes[1].angle_rad = 0.8;
  spec.fs_Hz = 2560;
  spec.band_high_Hz = 1000;
  spec.samples = 102400;  // 40 s
  const auto warnings = warnings_of(synth::synthesise(spec).record, band(400, 600));
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("double_peak: "), HasSubstr("(0.0400 Hz apart)"))));
}

}  // namespace percuss::pipeline::warnings_test
