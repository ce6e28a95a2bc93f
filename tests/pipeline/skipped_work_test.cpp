#include "pipeline/skipped_work.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json_schema.hpp"
#include "support/messages.hpp"
#include "support/modal_frfs.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::skipped_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

synth::SynthSpec bat() {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 1);
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return spec;
}

double share_of(const Analysis& analysis, const std::string& code) {
  for (const SkippedWork& one : skipped_work(analysis)) {
    if (one.code == code) return one.share.value_or(1);
  }
  return 0;
}

std::size_t calls_of(const Analysis& analysis, const std::string& name) {
  for (const auto& stage : analysis.trace().stages()) {
    if (stage.name == name) return stage.calls;
  }
  return 0;
}

TEST(SkippedWork, IsEverythingAtFirstAndComputesNothing) {
  const Analysis analysis(synth::synthesise(bat()).record, {});
  EXPECT_THAT(test::codes_of(skipped_work(analysis)), ElementsAre("modes", "classes", "stabilisation", "per_hit"));
  EXPECT_TRUE(analysis.trace().stages().empty());
}

TEST(SkippedWork, IncludesTheAccelerationsWhenOnlyTheForceIsDemanded) {
  const Analysis analysis(synth::synthesise(bat()).record, {});
  analysis.force_hits();
  EXPECT_EQ(share_of(analysis, "channels"), 1);
  EXPECT_EQ(calls_of(analysis, "read acceleration"), 0U);
}

// Three rows of one hit each: a rejected hit is neither read nor transformed.
TEST(SkippedWork, IncludesRejectedHits) {
  const Analysis all(synth::synthesise(bat()).record, {}), fewer(synth::synthesise(bat()).record, {.reject_hits = {1}});
  all.frfs();
  fewer.frfs();
  EXPECT_NEAR(share_of(fewer, "rejected"), 1.0 / 3, 1e-12);
  EXPECT_EQ(calls_of(fewer, "read acceleration") * 3, calls_of(all, "read acceleration") * 2);
  EXPECT_EQ(calls_of(fewer, "fft") * 3, calls_of(all, "fft") * 2);
}

// Long rows whose responses decay within a hundredth of their length.
TEST(SkippedWork, IncludesTheDecayedTailsOfLongRows) {
  synth::SynthSpec spec = bat();
  spec.samples = std::size_t{1} << 18U;
  const Analysis analysis(synth::synthesise(spec).record, {.band_Hz = std::pair{100.0, 400.0}});
  EXPECT_EQ(analysis.modes().size(), 1U);
  EXPECT_GT(share_of(analysis, "tail"), 0.9);
  EXPECT_EQ(calls_of(analysis, "decay"), calls_of(analysis, "read acceleration"));
  EXPECT_LT(analysis.lines().samples, spec.samples / 10);
}

TEST(SkippedWork, IncludesLinesOutsideTheBandAndTheForceOutsideItsPulse) {
  const Analysis analysis(synth::synthesise(bat()).record, {.band_Hz = std::pair{100.0, 400.0}});
  analysis.frfs();
  const acquire::LineRange& lines = analysis.lines();
  EXPECT_NEAR(share_of(analysis, "lines"),
              1 - static_cast<double>(lines.count) / (static_cast<double>(lines.samples) / 2 + 1), 1e-12);
  EXPECT_GT(share_of(analysis, "lines"), 0.5);
  EXPECT_GT(share_of(analysis, "force_zeros"), 0.9);
  EXPECT_THAT(test::codes_of(skipped_work(analysis)), IsSupersetOf({"modes", "stabilisation"}));
  analysis.modes();
  EXPECT_EQ(share_of(analysis, "modes"), 0);
}

// In a long record the samples between the hits and after their decay are not transformed.
TEST(SkippedWork, IncludesSilenceAndDecayedTailsOfALongRecord) {
  synth::SynthSpec spec = bat();
  spec.layout = synth::SynthLayout::continuous;
  spec.samples = std::size_t{30} * 8192;
  spec.hits = 2;
  spec.hit_times_s = {10, 20};
  const Analysis analysis(synth::synthesise(spec).record, {});
  analysis.frfs();
  EXPECT_GT(share_of(analysis, "silence") + share_of(analysis, "tail"), 0.8);
  EXPECT_LT(analysis.lines().samples, 3U * 8192);
}

TEST(SkippedWork, IsListedByExplain) {
  const test::ScratchFolder folder;
  ASSERT_EQ(test::run_percuss({"synth", "double-hit", "-o", folder.file("bat.h5")}).code, 0);
  const auto outcome = test::run_percuss({"analyze", folder.file("bat.h5"), "--explain", "--only", "modes"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("40.0 %  accelerations of hits that cannot be used"));
  EXPECT_THAT(outcome.err, HasSubstr("all  the stabilisation diagram"));
  const auto json = test::run_percuss({"analyze", folder.file("bat.h5"), "--explain", "--json"});
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_THAT(test::schema_violations(document, test::schema_named("analysis")), testing::IsEmpty());
  EXPECT_EQ(document["skipped"][0]["code"], "rejected");
}

}  // namespace percuss::pipeline::skipped_test
