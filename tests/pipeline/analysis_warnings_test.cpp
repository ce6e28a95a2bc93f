#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>

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
