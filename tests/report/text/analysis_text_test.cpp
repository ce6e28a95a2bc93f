#include "report/text/analysis_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/text/frf_terminal_plot.hpp"
#include "report/text/text_table.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "support/synthetic_files.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::analysis_text_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

synth::SynthSpec bat() {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                      {.freq_Hz = 1900,
                       .damping_ratio = 0.01,
                       .type = synth::SynthModeType::hoop,
                       .order = 1,
                       .amplitude_per_sqrt_kg = 2.4}},
                     1);
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

std::string text_of(const synth::SynthSpec& spec, const TextOptions& options = {}) {
  const pipeline::Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  return analysis_text(analysis, options);
}

TEST(AnalysisText, ContainsConditionsAndModes) {
  const std::string text = text_of(bat());
  EXPECT_THAT(text, AllOf(HasSubstr("8.192 kHz · 3 hits × 2 accelerometers (0°, 90°) · band 60–3200 Hz"),
                          HasSubstr("bending 1"), HasSubstr("hoop 1"), HasSubstr("averages: 3")));
  EXPECT_THAT(text, Not(HasSubstr("!")));  // no warning
  EXPECT_FALSE(text.ends_with("\n\n"));
}

TEST(AnalysisText, ContainsOnlyTheChosenSections) {
  EXPECT_THAT(text_of(bat(), {.sections = {ReportSection::hits}}),
              AllOf(HasSubstr("verdict"), Not(HasSubstr("first moves")), Not(HasSubstr("bending"))));
  EXPECT_THAT(text_of(bat(), {.sections = {ReportSection::frf}}),
              AllOf(HasSubstr("FRFs: "), Not(HasSubstr("verdict")), Not(HasSubstr("coherence"))));
  EXPECT_THAT(text_of(bat(), {.sections = {ReportSection::modes}}),
              AllOf(HasSubstr("damping"), Not(HasSubstr("bending"))));
}

TEST(AnalysisText, GivesTheReasonBesideARejectedHit) {
  synth::SynthSpec spec = bat();
  spec.faults = {{.hit = 1, .kind = synth::SynthFaultKind::double_hit, .ratio = 0.3, .delay_s = 0.02}};
  const std::string text = text_of(spec);
  EXPECT_THAT(text, HasSubstr("rejected: second hit after 20.0"));
  EXPECT_THAT(text, HasSubstr("! 1 of 3 hits not used"));
}

TEST(AnalysisText, StatesThatNoHitCanBeUsed) {
  synth::SynthSpec spec = bat();
  for (std::size_t hit = 0; hit < spec.hits; ++hit)
    spec.faults.push_back({.hit = hit, .kind = synth::SynthFaultKind::missing});
  EXPECT_THAT(text_of(spec), AllOf(HasSubstr("no hit can be used"), Not(HasSubstr("damping"))));
}

TEST(AnalysisText, ListsTheModesOfEachHitIfChosen) {
  const pipeline::Analysis analysis(synth::synthesise(bat()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  const std::size_t plain = test::lines_of(analysis_text(analysis)).size();
  const std::size_t more = test::lines_of(analysis_text(analysis, {.per_hit = true})).size();
  EXPECT_EQ(more, plain + 2 + 3 * analysis.modes().size());  // a blank, the heads, three hits' modes
}

TEST(AnalysisText, StatesTheSeparationOfVeryClosePairs) {
  synth::SynthSpec spec = bat();
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
    for (const std::string& line : test::lines_of(text_of(bat(), {.width = width}))) {
      EXPECT_LE(text_width(line), width) << line;
    }
  }
}

// Each mode's number stands at its frequency. The top row shows the peak of the hoop mode, and nothing beside it.
TEST(FrfTerminalPlot, ShowsThePeaksAboveTheirNumbers) {
  const pipeline::Analysis analysis(synth::synthesise(bat()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  const auto rows = test::lines_of(frf_terminal_plot(analysis, 108));
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_THAT(rows[9], AllOf(HasSubstr("60 Hz"), HasSubstr("3.2 kHz")));
  EXPECT_THAT(rows[0], HasSubstr(" dB "));
  EXPECT_EQ(rows[8].find('1') - 8, 100 * (200 - 60) / (3200 - 60));
  const std::size_t hoop = rows[8].find('2') - 8;
  EXPECT_EQ(hoop, 100 * (1900 - 60) / (3200 - 60));
  const auto cell = [&](std::size_t row, std::size_t column) {
    return rows[row].substr(rows[row].size() - 300 + 3 * column, 3);  // three bytes a character
  };
  EXPECT_NE(cell(0, hoop), "\u2800");
  for (const std::size_t beside : {hoop - 20, hoop + 20}) EXPECT_EQ(cell(0, beside), "\u2800");
}

TEST(FrfTerminalPlot, IsEmptyWhenTooNarrow) {
  const pipeline::Analysis analysis(synth::synthesise(bat()).record,
                                    {.band_Hz = std::pair{60.0, 3200.0}, .threads = 1});
  EXPECT_EQ(frf_terminal_plot(analysis, 40), "");
}

// This test has no terminal. .ci/shells tests the output on a terminal.
TEST(FrfTerminalPlot, AppearsOnTerminalsOnly) {
  const test::ScratchFolder folder;
  test::write_small_test(folder.file("bat.h5"));
  EXPECT_THAT(test::run_percuss({"analyze", folder.file("bat.h5")}).out, Not(HasSubstr("\xE2\xA0")));
}

}  // namespace percuss::report::analysis_text_test
