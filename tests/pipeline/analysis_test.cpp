#include "pipeline/analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "core/error.hpp"
#include "report/json/analysis_json.hpp"
#include "support/input_error.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::analysis_test {

synth::SynthSpec bat(std::uint64_t seed = 0) {
  synth::SynthSpec spec;
  spec.fs_Hz = 12800;
  spec.samples = 12800;
  spec.seed = seed;
  spec.modes = {{.freq_Hz = 180, .damping_ratio = 0.01, .order = 1, .angle_rad = 0.4, .amplitude_per_sqrt_kg = 1.7},
                {.freq_Hz = 1900,
                 .damping_ratio = 0.003,
                 .type = synth::SynthModeType::hoop,
                 .order = 1,
                 .angle_rad = 0.2,
                 .amplitude_per_sqrt_kg = 2.4}};
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return spec;
}

struct Reads {
  std::size_t force = 0, accel = 0;
  std::set<std::size_t> channels;
};

// The record with a count of the samples read.
acquire::Record counted(acquire::Record record, const std::shared_ptr<Reads>& reads) {
  record.read_force_N = [inner = record.read_force_N, reads](std::size_t row, std::size_t first,
                                                             std::span<double> out) {
    reads->force += out.size();
    inner(row, first, out);
  };
  record.read_accel_mps2 = [inner = record.read_accel_mps2, reads](std::size_t row, std::size_t channel,
                                                                   std::size_t first, std::span<double> out) {
    reads->accel += out.size();
    reads->channels.insert(channel);
    inner(row, channel, first, out);
  };
  return record;
}

std::set<std::string> stages(const Analysis& analysis) {
  std::set<std::string> names;
  for (const auto& stage : analysis.trace().stages()) names.insert(stage.name);
  return names;
}

Analysis analysis_of(acquire::Record record, AnalysisOptions options = {}) {
  options.band_Hz = {60, 3200};
  options.threads = 1;
  return {std::move(record), std::move(options)};
}

TEST(Analysis, RunsOnlyTheHitStageForTheHitsSection) {
  const auto reads = std::make_shared<Reads>();
  const Analysis analysis = analysis_of(counted(synth::synthesise(bat()).record, reads));
  report::analysis_json(analysis, {.sections = {report::ReportSection::hits}});
  EXPECT_EQ(stages(analysis), std::set<std::string>{"hits"});
  EXPECT_EQ(reads->accel, 0U);
}

TEST(Analysis, RunsNoIdentificationForFrfs) {
  const Analysis analysis = analysis_of(synth::synthesise(bat()).record);
  analysis.frfs();
  EXPECT_EQ(stages(analysis), (std::set<std::string>{"hits", "read acceleration", "fft", "agreement", "frf"}));
}

TEST(Analysis, RunsNoIdentificationForTheStabilisationDiagramAndNoDiagramForModes) {
  const Analysis analysis = analysis_of(synth::synthesise(bat()).record);
  EXPECT_FALSE(analysis.stabilisation().poles.empty());
  EXPECT_EQ(stages(analysis),
            (std::set<std::string>{"hits", "read acceleration", "fft", "agreement", "stabilisation"}));
  const Analysis other = analysis_of(synth::synthesise(bat()).record);
  other.modes();
  EXPECT_FALSE(stages(other).contains("stabilisation"));
}

TEST(Analysis, TransformsEachSignalOnce) {
  const auto reads = std::make_shared<Reads>();
  const Analysis analysis = analysis_of(counted(synth::synthesise(bat()).record, reads));
  report::analysis_json(analysis);
  report::analysis_json(analysis);
  for (const auto& stage : analysis.trace().stages()) {
    const std::size_t calls = stage.name == "fft"                 ? 15U  // 5 hits × (force + 2 accelerations)
                              : stage.name == "read acceleration" ? 10U
                                                                  : 1U;
    EXPECT_EQ(stage.calls, calls) << stage.name;
  }
  EXPECT_EQ(reads->accel, 5U * 2U * 12800U);
}

TEST(Analysis, ReadsNoMoreThanTheChannelsItHas) {
  const auto reads = std::make_shared<Reads>();
  acquire::Record record = counted(synth::synthesise(bat()).record, reads);
  record.accel.resize(1);
  analysis_of(std::move(record)).modes();
  EXPECT_EQ(reads->channels, std::set<std::size_t>{0});
}

TEST(Analysis, GivesEqualBytesForAnyNumberOfThreads) {
  const acquire::Record record = synth::synthesise(bat(3)).record;
  std::set<std::string> documents;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    documents.insert(report::analysis_json(Analysis(record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = threads})));
  }
  EXPECT_EQ(documents.size(), 1U);
}

TEST(Analysis, ComputesTheSameFrfsWithModesAsWithoutThem) {
  const acquire::Record record = synth::synthesise(bat(4)).record;
  const Analysis before(record, {.band_Hz = std::pair{60.0, 3200.0}});
  const std::vector<acquire::PointFrf>& expected = before.frfs();
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const Analysis beside(record, {.band_Hz = std::pair{60.0, 3200.0}, .threads = threads});
    beside.compute_modes_and_frfs();
    EXPECT_EQ(beside.modes().size(), before.modes().size());
    const std::vector<acquire::PointFrf>& frfs = beside.frfs();
    ASSERT_EQ(frfs.size(), expected.size());
    for (std::size_t i = 0; i < frfs.size(); ++i) {
      EXPECT_EQ(frfs[i].channel, expected[i].channel);
      EXPECT_EQ(frfs[i].frf.value, expected[i].frf.value);
      EXPECT_EQ(frfs[i].frf.coherence, expected[i].frf.coherence);
    }
    const auto traced = beside.trace().stages();
    const auto averaging =
        std::find_if(traced.begin(), traced.end(), [](const auto& stage) { return stage.name == "frf"; });
    ASSERT_NE(averaging, traced.end());
    EXPECT_EQ(averaging->calls, 1U);
  }
}

TEST(Analysis, FindsTheModesAndTheirTypes) {
  const Analysis analysis = analysis_of(synth::synthesise(bat(1)).record);
  ASSERT_EQ(analysis.modes().size(), 2U);
  EXPECT_LE(std::abs(analysis.modes()[0].pole.freq_Hz - 180), 5 * analysis.modes()[0].freq_std_Hz);
  EXPECT_LE(std::abs(analysis.modes()[1].pole.freq_Hz - 1900), 5 * analysis.modes()[1].freq_std_Hz);
  EXPECT_EQ(analysis.classifications()[0].type, identify::ModeType::bending);
  EXPECT_EQ(analysis.classifications()[1].type, identify::ModeType::hoop);
  EXPECT_EQ(analysis.modes_per_hit().size(), 10U);
}

// The modes that the user does not list take part in the fit, and FRFs and peaks are judged with them.
TEST(Analysis, JudgesTheFitByAllModesThatTookPart) {
  const acquire::Record record = synth::synthesise(bat()).record;
  const std::pair band{60.0, 3200.0};
  const Analysis whole = analysis_of(record, {.band_Hz = band});
  ASSERT_EQ(whole.modes().size(), 2U);
  EXPECT_EQ(whole.fitted_modes().size(), 2U);
  for (const identify::IdentifyOptions& chosen :
       {identify::IdentifyOptions{.modes = 1}, identify::IdentifyOptions{.start_Hz = {1900}}}) {
    const Analysis part = analysis_of(record, {.band_Hz = band, .modes = chosen});
    ASSERT_EQ(part.modes().size(), 1U);
    ASSERT_EQ(part.fitted_modes().size(), 2U);
    EXPECT_LT(part.fitted_modes()[0].pole.freq_Hz, part.fitted_modes()[1].pole.freq_Hz);
    ASSERT_EQ(part.synthesis().size(), whole.synthesis().size());
    for (std::size_t o = 0; o < part.synthesis().size(); ++o)
      EXPECT_EQ(part.synthesis()[o].frac, whole.synthesis()[o].frac) << o;
    EXPECT_EQ(part.fit().mode_frac.size(), 1U);
    EXPECT_EQ(part.unexplained_peaks().size(), whole.unexplained_peaks().size());
  }
}

TEST(Analysis, RejectsADoubleHitUnlessTheUserAcceptsIt) {
  synth::SynthSpec spec = bat();
  spec.faults = {{.hit = 2, .kind = synth::SynthFaultKind::double_hit, .ratio = 0.3, .delay_s = 0.010}};
  const acquire::Record record = synth::synthesise(spec).record;
  EXPECT_FALSE(analysis_of(record).hits()[2].accepted);
  const Analysis kept = analysis_of(record, {.accept_hits = {2}});
  EXPECT_TRUE(kept.hits()[2].accepted);
  EXPECT_TRUE(kept.hits()[2].by_user);
  const Analysis without = analysis_of(record, {.reject_hits = {0}});
  EXPECT_FALSE(without.hits()[0].accepted);
  EXPECT_EQ(without.frfs().front().frf.averages, 3U);
}

TEST(Analysis, IsNotPossibleWithoutAUsableHit) {
  synth::SynthSpec spec = bat();
  for (std::size_t hit = 0; hit < 5; ++hit) spec.faults.push_back({.hit = hit, .kind = synth::SynthFaultKind::missing});
  const Analysis analysis = analysis_of(synth::synthesise(spec).record);
  const std::string document = report::analysis_json(analysis);
  EXPECT_FALSE(analysis.possible());
  EXPECT_NE(document.find("no_pulse"), std::string::npos);
  EXPECT_EQ(document.find("nan"), std::string::npos);
  EXPECT_THROW(analysis.frfs(), InputError);
}

TEST(Analysis, RefusesBandsAndHitsThatTheRecordDoesNotHave) {
  const acquire::Record record = synth::synthesise(bat()).record;
  EXPECT_THROW(Analysis(record, {.band_Hz = std::pair{100.0, 101.0}}).lines(), InputError);
  EXPECT_THROW(Analysis(record, {.band_Hz = std::pair{100.0, 9e9}}).lines(), InputError);
  EXPECT_THROW(Analysis(record, {.accept_hits = {7}}).hits(), InputError);
}

TEST(Analysis, NamesTheForceWhenItShowsNoBandwidth) {
  std::vector<double> force(4096), accel(4096);
  std::fill_n(force.begin() + 500, 20, 1e308);  // the transform overflows
  accel[510] = 1;
  const Analysis analysis(acquire::record_in_memory(12800, {force}, {{accel}}), {});
  const std::string message = test::input_error_of([&] { analysis.lines(); });
  EXPECT_THAT(message, testing::HasSubstr("the force shows no bandwidth"));
  EXPECT_THAT(message, testing::HasSubstr("or state the band"));
  EXPECT_THAT(message, testing::Not(testing::HasSubstr("0:0")));
}

TEST(Analysis, CorrectsTheExponentialWindowExactly) {
  synth::SynthSpec spec = bat();
  spec.noise = {};
  const Analysis analysis = analysis_of(synth::synthesise(spec).record, {.exponential_end = 0.01});
  ASSERT_EQ(analysis.modes().size(), 2U);
  constexpr double kRounding = 1e-8;  // of fits to noise-free lines
  EXPECT_LE(std::abs(analysis.modes()[0].pole.damping_ratio / 0.01 - 1), kRounding);
  EXPECT_LE(std::abs(analysis.modes()[1].pole.damping_ratio / 0.003 - 1), kRounding);
}

// The identification of 60 modes takes seconds; the budget ends it at the next check of a fit.
TEST(Analysis, EndsWhenItsBudgetIsSpent) {
  synth::SynthSpec many = bat();
  for (int m = 0; m < 60; ++m) {
    many.modes.push_back({.freq_Hz = 250.0 + 25 * m,
                          .damping_ratio = 0.01,
                          .order = 2,
                          .angle_rad = 0.1 * m,
                          .amplitude_per_sqrt_kg = 1});
  }
  const Analysis analysis(synth::synthesise(many).record, {.budget = Budget{.time_s = 0.05}});
  try {
    analysis.modes();
    FAIL() << "the budget was not spent";
  } catch (const BudgetSpent& error) {
    EXPECT_EQ(error.resource(), Resource::time);
  }
  EXPECT_THROW(analysis.modes(), BudgetSpent);  // the time stays spent
}

}  // namespace percuss::pipeline::analysis_test
