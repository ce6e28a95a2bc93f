#include "report/html/trust_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::report::trust_section_test {

using testing::HasSubstr;

TEST(TrustSection, StatesConsequenceAndRemedyOnceEach) {
  const std::string html = trust_section(
      {pipeline::with_remedy({"frac", "the modes explain 98 % < 99 %"}, "take more hits"), {"reversed", "accel 2"}},
      {});
  EXPECT_THAT(html, HasSubstr("How far can this test be trusted?"));
  EXPECT_THAT(html, HasSubstr("<li class=\"warn\"><b>Results may be off.</b> the modes explain 98 % &lt; 99 % "
                              "<span class=\"remedy\">Remedy: take more hits.</span></li>"));
  EXPECT_LT(html.find("accel 2"), html.find("the modes explain")) << "most serious first";
  EXPECT_EQ(html.find("take more hits"), html.rfind("take more hits"));
}

TEST(TrustSection, SaysThatNothingWasFound) { EXPECT_THAT(trust_section({}, {}), HasSubstr("Nothing was found")); }

}  // namespace percuss::report::trust_section_test
