#include "core/warning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace percuss::warnings::warning_test {

using testing::ElementsAre;

constexpr auto kRanking = std::to_array<RankedCode>({
    {"wrong", Severity::reject},
    {"doubtful", Severity::warn},
    {"vague", Severity::warn},
    {"remark", Severity::info},
});

std::vector<std::string> messages_of(const std::vector<Warning>& warnings) {
  std::vector<std::string> out;
  for (const Warning& warning : warnings) out.push_back(warning.message);
  return out;
}

TEST(RankedWarnings, ComeBySeverityThenByTheRanking) {
  const auto out = ranked({{"remark", "a"}, {"vague", "b"}, {"doubtful", "c"}, {"wrong", "d"}}, kRanking);
  EXPECT_THAT(messages_of(out), ElementsAre("d", "c", "b", "a"));
  EXPECT_EQ(out.front().severity, Severity::reject);
  EXPECT_EQ(out.back().severity, Severity::info);
}

TEST(RankedWarnings, KeepASeverityOfTheirOwn) {
  const auto out = ranked(
      {{"wrong", "a"}, {.code = "remark", .message = "b", .severity = Severity::reject}, {"doubtful", "c"}}, kRanking);
  EXPECT_THAT(messages_of(out), ElementsAre("a", "b", "c"));
  EXPECT_EQ(out[1].severity, Severity::reject);
}

TEST(RankedWarnings, OfUnknownCodesAreLastOfTheSeverityWarn) {
  const auto out = ranked({{"remark", "a"}, {"unknown", "b"}, {"vague", "c"}, {"unknown", "d"}}, kRanking);
  EXPECT_THAT(messages_of(out), ElementsAre("c", "b", "d", "a"));
  EXPECT_EQ(out[1].severity, Severity::warn);
}

TEST(RankedWarnings, OfOneCodeKeepTheirOrder) {
  EXPECT_THAT(messages_of(ranked({{"vague", "b"}, {"vague", "a"}}, kRanking)), ElementsAre("b", "a"));
}

TEST(Warnings, EndMessagesWithTheirRemedy) {
  const Warning warning = with_remedy({"vague", "the range is wide", {"hold"}}, "measure again");
  EXPECT_EQ(warning.message, "the range is wide; measure again");
  EXPECT_EQ(warning.remedy, "measure again");
  EXPECT_THAT(warning.options, ElementsAre("hold"));
}

}  // namespace percuss::warnings::warning_test
