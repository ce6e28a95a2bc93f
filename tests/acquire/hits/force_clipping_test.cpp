#include "acquire/hits/force_clipping.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/force_row.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::acquire::force_clipping_test {

std::size_t overloads(const Hit& hit) {
  return static_cast<std::size_t>(std::count_if(hit.findings.begin(), hit.findings.end(),
                                                [](const Finding& f) { return f.code == FindingCode::overload; }));
}

/// A row with a pulse of five samples on a baseline, clipped at `clipping_level_N`.
std::vector<double> clipped_row(double peak_N, double clipping_level_N, double baseline_N, double onset) {
  std::vector<double> row(4000, baseline_N);
  test::add_haversine(row, onset, 5, peak_N);
  for (double& value : row) value = std::clamp(value, -clipping_level_N, clipping_level_N);
  return row;
}

TEST(ForceClipping, IsFoundInHitsThatPeakWhereAnotherIsClipped) {
  const auto hits =
      find_hits(test::force_record(25600, {clipped_row(150, 200, 0.1, 500.3), clipped_row(215, 200, 0.7, 500.5),
                                           clipped_row(400, 200, 0.3, 500.7)}));
  EXPECT_EQ(overloads(hits[0]), 0U);
  ASSERT_EQ(overloads(hits[1]), 1U);
  EXPECT_EQ(overloads(hits[2]), 1U);
  const Finding& finding = hits[1].findings.back();
  EXPECT_EQ(finding.severity, Severity::reject);
  EXPECT_GE(finding.value, 1);
  EXPECT_LE(finding.value, 2);
}

TEST(ForceClipping, IsFoundInNegativePulses) {
  auto record = test::force_record(
      25600, {clipped_row(-150, 200, 0, 500.3), clipped_row(-215, 200, 0, 500.5), clipped_row(-400, 200, 0, 500.7)});
  const auto hits = find_hits(record);
  EXPECT_EQ(overloads(hits[0]), 0U);
  EXPECT_EQ(overloads(hits[1]), 1U);
}

TEST(ForceClipping, IsNoneWhereAnotherHitExceedsIt) {
  std::vector<Hit> hits(3);
  for (Hit& hit : hits) hit.peak_N = 200;
  hits[0].findings.push_back({.code = FindingCode::overload, .severity = Severity::reject});
  hits[2].peak_N = 201;
  const Record record = test::force_record(25600, {{0.0}});
  grade_force_clipping(hits, record);
  EXPECT_EQ(overloads(hits[1]), 0U);
  hits[2].peak_N = 199;
  grade_force_clipping(hits, record);
  EXPECT_EQ(overloads(hits[1]), 1U);
  EXPECT_EQ(overloads(hits[2]), 0U);
}

TEST(ForceClipping, IsJudgedPerFile) {
  std::vector<Hit> hits(2);
  for (std::size_t h = 0; h < 2; ++h) hits[h] = {.row = h, .peak_N = 200};
  hits[0].findings.push_back({.code = FindingCode::overload, .severity = Severity::reject});
  Record record = test::force_record(25600, {{0.0}, {0.0}});
  record.files = {{.path = "a"}, {.path = "b"}};
  record.rows[1].file = 1;
  grade_force_clipping(hits, record);
  EXPECT_EQ(overloads(hits[1]), 0U);
}

TEST(ForceClipping, IsNoneInEqualHits) {
  const auto row = clipped_row(150, 1e9, 0, 500.3);
  const auto hits = find_hits(test::force_record(25600, {row, row, row}));
  ASSERT_EQ(hits.size(), 3U);
  for (const Hit& hit : hits) EXPECT_EQ(overloads(hit), 0U);
}

// A pulse of three samples has one or two clipped samples: no hit alone shows the clipping.
TEST(ForceClipping, IsFoundInEqualPeaksOfShortPulses) {
  const auto row = [](double peak_N, double onset) {
    std::vector<double> x(4000);
    test::add_haversine(x, onset, 3, peak_N);
    for (double& value : x) value = std::min(value, 150.0);
    return x;
  };
  const auto clipped = find_hits(test::force_record(25600, {row(300, 500.3), row(260, 500.4), row(340, 500.6)}));
  ASSERT_EQ(clipped.size(), 3U);
  for (const Hit& hit : clipped) EXPECT_EQ(overloads(hit), 1U);
  const auto some =
      find_hits(test::force_record(25600, {row(300, 500.3), row(260, 500.4), row(340, 500.6), row(100, 500.5)}));
  EXPECT_EQ(overloads(some[0]), 1U);
  EXPECT_EQ(overloads(some[3]), 0U);
}

TEST(ForceClipping, AgreesWithTheTruthOfEveryPreset) {
  for (const synth::SynthPreset& preset : synth::synth_presets()) {
    const synth::SyntheticTest test = synth::synthesise(synth::synth_preset(preset.name));
    const auto hits = find_hits(test.record);
    ASSERT_EQ(hits.size(), test.truth.hits.size()) << preset.name;
    for (std::size_t h = 0; h < hits.size(); ++h) {
      EXPECT_EQ(overloads(hits[h]) > 0, test.truth.hits[h].flag == "clipped") << preset.name << ' ' << h;
    }
  }
}

}  // namespace percuss::acquire::force_clipping_test
