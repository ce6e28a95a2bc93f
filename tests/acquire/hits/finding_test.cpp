#include "acquire/hits/finding.hpp"

#include <gtest/gtest.h>

namespace percuss::acquire::finding_test {

TEST(Finding, HasTheNamesThatScriptsRelyOn) {
  EXPECT_STREQ(name_of(FindingCode::double_hit), "double_hit");
  EXPECT_STREQ(name_of(FindingCode::overload), "overload");
  EXPECT_STREQ(name_of(FindingCode::late_trigger), "late_trigger");
  EXPECT_STREQ(name_of(FindingCode::no_pulse), "no_pulse");
  EXPECT_STREQ(name_of(FindingCode::weak), "weak");
  EXPECT_STREQ(name_of(FindingCode::truncated_decay), "truncated_decay");
  EXPECT_STREQ(name_of(FindingCode::low_bandwidth), "low_bandwidth");
  EXPECT_STREQ(name_of(FindingCode::low_coherence), "low_coherence");
  EXPECT_STREQ(name_of(FindingCode::outlier), "outlier");
  EXPECT_STREQ(name_of(FindingCode::polarity), "polarity");
  EXPECT_STREQ(name_of(Severity::info), "info");
  EXPECT_STREQ(name_of(Severity::warn), "warn");
  EXPECT_STREQ(name_of(Severity::reject), "reject");
}

TEST(Finding, RejectsAHitAtAnyPlaceInTheList) {
  const Finding info{.code = FindingCode::double_hit, .severity = Severity::info};
  const Finding warn{.code = FindingCode::weak, .severity = Severity::warn};
  const Finding reject{.code = FindingCode::overload, .severity = Severity::reject};
  EXPECT_FALSE(rejects({}));
  EXPECT_FALSE(rejects({info, warn}));
  EXPECT_TRUE(rejects({reject}));
  EXPECT_TRUE(rejects({reject, info}));
  EXPECT_TRUE(rejects({info, warn, reject}));
}

}  // namespace percuss::acquire::finding_test
