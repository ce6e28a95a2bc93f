#include "report/study_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace percuss::report::study_report_test {

using testing::HasSubstr;
using testing::Not;

CommandReport report_of(bool without_family) {
  std::vector<metrics::StudyBat> bats(2);
  bats[0].id = "a";
  bats[1].id = "b";
  for (metrics::StudyBat& bat : bats) bat.length_in = 33;
  bats[1].without_family = without_family;
  return study_report(metrics::study_of(bats), std::nullopt);
}

TEST(StudyReport, SaysThatModesWithoutAFamilyTakeNoPart) {
  const CommandReport report = report_of(true);
  EXPECT_THAT(report.text.text(400), HasSubstr("! the modes of 1 of 2 bats have no family, as with one accelerometer"));
  EXPECT_THAT(report.json, HasSubstr("\"bats_without_family\": [\n    \"b\"\n  ]"));
  EXPECT_THAT(report_of(false).text.text(400), Not(HasSubstr("no family")));
}

}  // namespace percuss::report::study_report_test
