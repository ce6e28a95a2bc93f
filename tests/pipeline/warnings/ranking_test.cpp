#include "pipeline/warnings/ranking.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/messages.hpp"

namespace percuss::pipeline::ranking_test {

using acquire::FindingCode;
using acquire::Severity;
using test::codes_of;
using testing::ElementsAre;

TEST(Ranking, PutsTheMostSeriousFirst) {
  const auto out = ranked({{"truncated_decay", "c"},
                           {"frac", "b"},
                           {"reversed", "a"},
                           {"new_code", "d"},
                           {.code = "frac", .message = "e", .severity = Severity::reject}});
  EXPECT_THAT(codes_of(out), ElementsAre("reversed", "frac", "frac", "new_code", "truncated_decay"));
  for (const Warning& warning : out) EXPECT_TRUE(warning.severity);
  EXPECT_EQ(*out.front().severity, Severity::reject);
  EXPECT_EQ(*out.back().severity, Severity::info);
}

TEST(Ranking, PutsACauseBeforeItsConsequence) {
  const auto out = ranked({{"frac", "a"}, {"model_misfit", "b"}, {"unclaimed_peaks", "c"}, {"double_peak", "d"}});
  EXPECT_THAT(codes_of(out), ElementsAre("double_peak", "unclaimed_peaks", "model_misfit", "frac"));
}

TEST(Ranking, EndsMessagesWithTheirRemedy) {
  const Warning warning = with_remedy({"frac", "the modes explain too little"}, "take more hits");
  EXPECT_EQ(warning.message, "the modes explain too little; take more hits");
  EXPECT_EQ(warning.remedy, "take more hits");
}

AnalysedHit hit_with(FindingCode code, Severity severity, bool accepted) {
  AnalysedHit hit{.accepted = accepted};
  hit.hit.findings.push_back({.code = code, .severity = severity, .value = 0.3, .message = "what was found"});
  return hit;
}

TEST(TrustStatements, NameEachFindingOnceWithItsHits) {
  const std::vector<AnalysedHit> hits{hit_with(FindingCode::double_hit, Severity::reject, false),
                                      hit_with(FindingCode::weak, Severity::warn, true),
                                      hit_with(FindingCode::weak, Severity::warn, true)};
  const auto out = trust_statements({{"hits_disagree", "a mixture"}}, hits);
  EXPECT_THAT(codes_of(out), ElementsAre("hits_disagree", "weak", "double_hit"));
  EXPECT_EQ(out[1].message, "hits 2, 3: what was found (the first of them)");
  EXPECT_EQ(out[2].message, "hit 1 (not used): what was found");
  EXPECT_EQ(*out[2].severity, Severity::info);
}

TEST(TrustStatements, LeaveFindingsToTheWarningOfTheirCode) {
  const std::vector<AnalysedHit> hits{hit_with(FindingCode::polarity, Severity::warn, true)};
  EXPECT_THAT(codes_of(trust_statements({{"polarity", "all hits"}}, hits)), ElementsAre("polarity"));
}

TEST(TrustStatements, StateEqualMessagesOnce) {
  EXPECT_THAT(codes_of(trust_statements({{"input", "a note"}, {"input", "a note"}, {"input", "another"}}, {})),
              ElementsAre("input", "input"));
}

// double_hits_used summarises the findings of used hits, but not the findings of rejected hits.
TEST(TrustStatements, StateDoubleHitsOnce) {
  const Warning used{"double_hits_used", "hits 1"};
  std::vector<AnalysedHit> hits{hit_with(FindingCode::double_hit, Severity::warn, true)};
  EXPECT_THAT(codes_of(trust_statements({used}, hits)), ElementsAre("double_hits_used"));
  hits.push_back(hit_with(FindingCode::double_hit, Severity::reject, false));
  const auto out = trust_statements({used}, hits);
  EXPECT_THAT(codes_of(out), ElementsAre("double_hits_used", "double_hit"));
  EXPECT_EQ(out[1].message, "hit 2 (not used): what was found");
}

}  // namespace percuss::pipeline::ranking_test
