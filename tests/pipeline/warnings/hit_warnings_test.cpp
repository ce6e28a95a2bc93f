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

TEST(HitWarnings, NameTheHumThatMayMoveBeforeAHit) {
  std::vector<AnalysedHit> hits(2, {.hit = {.peak_N = 100}, .accepted = true});
  EXPECT_TRUE(rest_warnings(hits, {}, {}).empty());
  hits[1].responses.push_back({.may_ring_before = true});
  const auto before = [&](const std::vector<Tone>& tones) { return rest_warnings(hits, {}, tones).at(0).message; };
  EXPECT_THAT(before({}), testing::StartsWith("the structure was not at rest before hit 2: damping"));
  EXPECT_THAT(before({{.freq_Hz = 641}}), testing::StartsWith("the structure was not at rest before hit 2"));
  EXPECT_THAT(before({{.freq_Hz = 49.98}}),
              testing::StartsWith("motion remains before hit 2 after the hum was removed: the structure was not at "
                                  "rest, or a harmonic of the mains lies at a mode. Damping"));
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

// The same survey, where the force of the stated hits is negative.
Warning polarity_in(const std::set<std::size_t>& negative, bool one_file = false) {
  DisagreeingTest test = survey_with({});
  test.record.force.to_SI = 10;
  for (const std::size_t h : negative)
    test.hits[h].hit.findings.push_back({.code = acquire::FindingCode::polarity, .value = -100.0 - 1.0 * (h == 3)});
  if (one_file) {
    test.record.files.resize(1);
    for (acquire::RowInfo& row : test.record.rows) row.file = 0;
  }
  const PointNames names(test.record, test.record.points());
  for (const Warning& warning : hit_warnings(test.record, test.hits, names)) {
    if (warning.code == "polarity") return warning;
  }
  return {};
}

TEST(HitWarnings, TurnTheWholeForceOnlyWhereAllHitsAreNegative) {
  const Warning all = polarity_in({0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_THAT(all.message, testing::HasSubstr("is negative during the pulse, down to -101 N: the FRFs have the wrong"));
  EXPECT_THAT(all.remedy, testing::HasSubstr("\"sign\": -1"));
  EXPECT_THAT(all.options, testing::ElementsAre("setup", "force_scale"));
}

// A set-up that states a direction cannot state a sign.
TEST(HitWarnings, TurnTheScaleOfAForceWithADirection) {
  DisagreeingTest test = survey_with({});
  test.record.force.axis = acquire::Direction{0, 0, 1};
  for (AnalysedHit& hit : test.hits)
    hit.hit.findings.push_back({.code = acquire::FindingCode::polarity, .value = -100});
  const auto warnings = hit_warnings(test.record, test.hits, PointNames(test.record, test.record.points()));
  const auto polarity =
      std::find_if(warnings.begin(), warnings.end(), [](const auto& w) { return w.code == "polarity"; });
  ASSERT_NE(polarity, warnings.end());
  EXPECT_THAT(polarity->remedy, testing::Not(testing::HasSubstr("sign\"")));
  EXPECT_THAT(polarity->options, testing::ElementsAre("force_scale"));
}

// One sign for the channel would turn the hits of the other points.
TEST(HitWarnings, TurnTheFilesOfThePointsWhoseForceIsNegative) {
  const Warning one = polarity_in({3, 4, 5});
  EXPECT_EQ(
      one.message,
      "the force of the hits at point 2 (P2.csv) is negative during the pulse, down to -101 N, and positive at all "
      "other hits: the FRFs have the wrong sign there; state the scale of the force in N per stored unit, one "
      "value for each file: -10 for P2.csv, 10 for the others");
  EXPECT_THAT(one.options, testing::ElementsAre("force_scale"));
  EXPECT_THAT(polarity_in({0, 1, 2, 3, 4, 5}).message,
              testing::AllOf(testing::HasSubstr("the hits at points 1 (P1.csv), 2 (P2.csv) is"),
                             testing::EndsWith("-10 for P1.csv, P2.csv, 10 for the others")));
}

TEST(HitWarnings, LeaveOutNegativeHitsThatShareAFileWithOthers) {
  for (const bool one_file : {false, true}) {
    const Warning some = polarity_in({3, 8}, one_file);
    EXPECT_THAT(some.message, testing::HasSubstr(one_file ? "hit 4 at point 1, hit 9 at point 2 is"
                                                          : "hit 4 at point 2 (P2.csv), hit 9 at point 3 (P3.csv) is"));
    EXPECT_EQ(some.remedy, "multiply the force of these hits by -1 in the data, or reject them");
    EXPECT_THAT(some.options, testing::ElementsAre("reject_hit"));
  }
}

}  // namespace percuss::pipeline::hit_warnings_test
