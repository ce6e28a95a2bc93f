#include "pipeline/warnings/hit_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace percuss::pipeline::hit_warnings_test {

bool warns(double peak_N, const std::string& code) {
  std::vector<AnalysedHit> hits;
  for (const double factor : {0.8, 1.0, 1.3}) hits.push_back({.hit = {.peak_N = factor * peak_N}, .accepted = true});
  const std::vector<Warning> warnings = hit_warnings({}, hits, PointNames());
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& one) { return one.code == code; });
}

// A force that is 1000 times too large, as where a sensitivity in V/N was stated as mV/N.
TEST(HitWarnings, DoubtAForceAboveThatOfAllHammers) {
  EXPECT_FALSE(warns(257, "implausible_force"));
  EXPECT_FALSE(warns(22e3, "implausible_force"));
  EXPECT_TRUE(warns(257e3, "implausible_force"));
  EXPECT_TRUE(warns(-257e3, "implausible_force"));
}

// A survey of three points from P1.csv to P3.csv with three hits each. The stated hits disagree with the others.
struct DisagreeingTest {
  acquire::Record record;
  std::vector<AnalysedHit> hits;
};

DisagreeingTest survey_with(const std::set<std::size_t>& poor, bool file_for_each_hit = false) {
  DisagreeingTest out;
  for (std::size_t h = 0; h < 9; ++h) {
    const std::size_t p = h / 3;
    const std::string number = std::to_string(p + 1);
    if (file_for_each_hit) {
      out.record.files.push_back({.path = "P" + number + "_" + std::to_string(h % 3 + 1) + ".csv"});
    } else if (h % 3 == 0) {
      out.record.files.push_back({.path = "P" + number + ".csv"});
    }
    out.record.rows.push_back({.file = out.record.files.size() - 1, .point = static_cast<int>(p)});
    out.hits.push_back({.hit = {.row = h, .peak_N = 100}, .point = static_cast<int>(p), .accepted = true});
    if (poor.contains(h))
      out.hits.back().hit.findings.push_back({.code = acquire::FindingCode::low_coherence, .value = 0.1});
  }
  return out;
}

Warning disagreement_in(const DisagreeingTest& test) {
  const PointNames names(test.record, test.record.points());
  for (const Warning& warning : hit_warnings(test.record, test.hits, names)) {
    if (warning.code == "hits_disagree") return warning;
  }
  return {};
}

TEST(HitWarnings, NameTheHitOfASurveyThatWasElsewhere) {
  for (const bool file_for_each_hit : {false, true}) {
    const Warning warning = disagreement_in(survey_with({4}, file_for_each_hit));
    EXPECT_EQ(warning.message,
              std::string("the other hits explain less than half of the response of hit 5 at point 2 ") +
                  (file_for_each_hit ? "(P2)" : "(P2.csv)") +
                  ": was another structure, point or sensor measured? The modes belong to a mixture; reject hit 5 if "
                  "it was elsewhere");
    EXPECT_THAT(warning.options, testing::ElementsAre("reject_hit"));
  }
  EXPECT_THAT(disagreement_in(survey_with({4, 8})).message,
              testing::AllOf(testing::HasSubstr("responses of hit 5 at point 2 (P2.csv), hit 9 at point 3 (P3.csv)"),
                             testing::EndsWith("reject hits 5, 9 if they were elsewhere")));
}

TEST(HitWarnings, AskForAPointWhoseHitsAllDisagree) {
  EXPECT_THAT(disagreement_in(survey_with({3, 4, 5})).message,
              testing::AllOf(testing::HasSubstr("responses of hits 4, 5, 6 at point 2 (P2.csv)"),
                             testing::EndsWith("measure this point again, or reject the hits that were elsewhere")));
}

// Files of hits of one point may be tests of different structures.
TEST(HitWarnings, SuggestToSeparateFilesThatAreHitsOfOnePoint) {
  DisagreeingTest test = survey_with({4});
  for (std::size_t h = 0; h < test.hits.size(); ++h) test.hits[h].point = test.record.rows[h].point = 0;
  const Warning warning = disagreement_in(test);
  EXPECT_THAT(warning.message, testing::EndsWith("analyse each file as a test of its own"));
  EXPECT_THAT(warning.options, testing::ElementsAre("files"));
  test.record.files.resize(1);
  for (acquire::RowInfo& row : test.record.rows) row.file = 0;
  EXPECT_THAT(disagreement_in(test).message, testing::EndsWith("reject this hit if it was elsewhere"));
}

}  // namespace percuss::pipeline::hit_warnings_test
