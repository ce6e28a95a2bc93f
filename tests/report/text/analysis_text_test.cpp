#include "report/text/analysis_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/text/text_table.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::analysis_text_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string text_of(const synth::SynthSpec& spec, const TextOptions& options = {}) {
  const pipeline::Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  return analysis_text(analysis, options);
}

TEST(AnalysisText, ContainsConditionsAndModes) {
  const std::string text = text_of(test::bending_and_hoop_spec());
  EXPECT_THAT(text, AllOf(HasSubstr("8.192 kHz · 3 hits × 2 accelerometers (0°, 90°) · band 60–3200 Hz"),
                          HasSubstr("bending 1"), HasSubstr("hoop 1"), HasSubstr("averages: 3")));
  EXPECT_THAT(text, Not(HasSubstr("!")));  // no warning
  EXPECT_FALSE(text.ends_with("\n\n"));
}

TEST(AnalysisText, ContainsOnlyTheChosenSections) {
  EXPECT_THAT(text_of(test::bending_and_hoop_spec(), {.sections = {ReportSection::hits}}),
              AllOf(HasSubstr("verdict"), Not(HasSubstr("first moves")), Not(HasSubstr("bending"))));
  EXPECT_THAT(text_of(test::bending_and_hoop_spec(), {.sections = {ReportSection::frf}}),
              AllOf(HasSubstr("FRFs: "), Not(HasSubstr("verdict")), Not(HasSubstr("coherence"))));
  EXPECT_THAT(text_of(test::bending_and_hoop_spec(), {.sections = {ReportSection::modes}}),
              AllOf(HasSubstr("damping"), Not(HasSubstr("bending"))));
}

// The text must say when the verdicts do not consider the accelerations.
TEST(AnalysisText, SaysThatTheForceAloneJudgesTheHits) {
  const auto says = HasSubstr("judged by their force alone");
  EXPECT_THAT(text_of(test::bending_and_hoop_spec(), {.sections = {ReportSection::hits}}), says);
  EXPECT_THAT(text_of(test::bending_and_hoop_spec(), {.sections = {ReportSection::hits, ReportSection::frf}}),
              Not(says));
  EXPECT_THAT(text_of(test::bending_and_hoop_spec()), Not(says));
}

TEST(AnalysisText, GivesTheReasonBesideARejectedHit) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::double_hit, .ratio = 0.3, .delay_s = 0.02}};
  const std::string text = text_of(spec);
  EXPECT_THAT(text, HasSubstr("rejected: second hit after 20.0"));
  EXPECT_THAT(text, HasSubstr("! 1 of 3 hits not used"));
}

TEST(AnalysisText, StatesThatNoHitCanBeUsed) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  for (std::size_t hit = 0; hit < spec.hits; ++hit)
    spec.faults.push_back({.hit = hit, .kind = synth::SynthFaultKind::missing});
  EXPECT_THAT(text_of(spec), AllOf(HasSubstr("no hit has a pulse of the force"), Not(HasSubstr("damping"))));
}

TEST(AnalysisText, ListsTheModesOfEachHitIfChosen) {
  const pipeline::Analysis analysis(synth::synthesise(test::bending_and_hoop_spec()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  const std::size_t plain = test::lines_of(analysis_text(analysis)).size();
  const std::size_t more = test::lines_of(analysis_text(analysis, {.per_hit = true})).size();
  EXPECT_EQ(more, plain + 2 + 3 * analysis.modes().size());  // a blank, the heads, three hits' modes
}

TEST(AnalysisText, StatesTheSeparationOfVeryClosePairs) {
  synth::SynthSpec spec = test::bending_and_hoop_spec();
  spec.modes = {spec.modes[1], spec.modes[1]};
  spec.modes[0].freq_Hz = 500;
  spec.modes[1].freq_Hz = 500.04;
  for (synth::SynthMode& mode : spec.modes) mode.damping_ratio = 2e-5;
  spec.modes[1].angle_rad = 0.8;
  spec.fs_Hz = 2560;
  spec.band_high_Hz = 1000;
  spec.samples = 102400;  // 40 s
  const pipeline::Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{400.0, 600.0}, .threads = 1});
  EXPECT_THAT(analysis_text(analysis, {.width = 200}), HasSubstr("split mode, 0.0400 Hz apart"));
}

TEST(AnalysisText, ObeysTheWidth) {
  for (const std::size_t width : {100U, 120U, 160U}) {
    for (const std::string& line : test::lines_of(text_of(test::bending_and_hoop_spec(), {.width = width}))) {
      EXPECT_LE(text_width(line), width) << line;
    }
  }
}

}  // namespace percuss::report::analysis_text_test
