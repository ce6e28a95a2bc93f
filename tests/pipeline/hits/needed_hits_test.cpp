#include "pipeline/hits/needed_hits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/analysis.hpp"
#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::pipeline::needed_hits_test {

using acquire::FindingCode, acquire::Severity;

AnalysedHit hit_with(FindingCode code, int point = 0) {
  AnalysedHit hit;
  hit.point = point;
  hit.hit.gated_N = {1};
  hit.hit.findings = {{.code = code, .severity = Severity::reject, .message = "reason"}};
  return hit;
}

AnalysedHit good_hit(int point = 0) {
  AnalysedHit hit;
  hit.point = point;
  hit.hit.gated_N = {1};
  hit.accepted = true;
  return hit;
}

TEST(NeededHits, StayRejectedWhereTwoOthersRemain) {
  std::vector<AnalysedHit> hits{good_hit(), hit_with(FindingCode::double_hit), good_hit()};
  accept_needed_hits(hits, 25600);
  EXPECT_FALSE(hits[1].accepted);
}

TEST(NeededHits, AreUsedWhereTheirPointHasTooFewOthers) {
  std::vector<AnalysedHit> hits{good_hit(1), good_hit(1), good_hit(2), hit_with(FindingCode::double_hit, 2),
                                hit_with(FindingCode::overload, 2)};
  accept_needed_hits(hits, 25600);
  EXPECT_TRUE(hits[3].accepted);
  EXPECT_EQ(hits[3].hit.findings[0].severity, Severity::warn);
  EXPECT_FALSE(hits[4].accepted);
}

TEST(NeededHits, PreferDoubleHitsToClippedForces) {
  std::vector<AnalysedHit> hits{hit_with(FindingCode::double_hit), hit_with(FindingCode::force_clipped),
                                hit_with(FindingCode::double_hit)};
  accept_needed_hits(hits, 25600);
  EXPECT_TRUE(hits[0].accepted);
  EXPECT_FALSE(hits[1].accepted);
}

TEST(NeededHits, StayRejectedWhereTheForceLacksTheSecondContact) {
  std::vector<AnalysedHit> hits{hit_with(FindingCode::double_hit), hit_with(FindingCode::double_hit)};
  hits[0].hit.peak = hits[1].hit.peak = hits[0].hit.gate_first = hits[1].hit.gate_first = 500;
  for (AnalysedHit& hit : hits) hit.hit.findings[0].delay_s = 0.01;
  hits[1].hit.gated_N.resize(300);  // 11.7 ms
  accept_needed_hits(hits, 25600);
  EXPECT_FALSE(hits[0].accepted);
  EXPECT_TRUE(hits[1].accepted);
}

// True poles from hits that all have a second contact: the whole force is used.
TEST(NeededHits, GiveTheTruePoles) {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7},
                      {.freq_Hz = 900, .damping_ratio = 0.01, .order = 2, .amplitude_per_sqrt_kg = 2}},
                     1);
  spec.hits = 3;
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  const AnalysisOptions options{.band_Hz = std::pair{60.0, 3200.0}, .threads = 1};
  const Analysis single(synth::synthesise(spec).record, options);
  for (std::size_t h = 0; h < 3; ++h) {
    spec.faults.push_back({.hit = h,
                           .kind = synth::SynthFaultKind::double_hit,
                           .ratio = 0.1,
                           .delay_s = 0.018 + 1e-3 * static_cast<double>(h)});
  }
  const Analysis twice(synth::synthesise(spec).record, options);
  ASSERT_EQ(twice.modes().size(), single.modes().size());
  for (std::size_t m = 0; m < single.modes().size(); ++m) {
    const identify::Mode& b = twice.modes()[m];
    EXPECT_LE(b.freq_std_Hz, 1e-4 * b.pole.freq_Hz) << m;
    EXPECT_LE(std::abs(b.pole.freq_Hz - spec.modes[m].freq_Hz), 5 * b.freq_std_Hz) << m;
    EXPECT_LE(std::abs(b.pole.damping_ratio - spec.modes[m].damping_ratio), 5 * b.damping_std) << m;
  }
  const std::vector<Warning> warnings = twice.warnings();
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const Warning& warning) { return warning.code == "double_hits_used"; }));
}

}  // namespace percuss::pipeline::needed_hits_test
