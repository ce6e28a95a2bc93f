#include "report/html/trust_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::report::trust_section_test {

using testing::HasSubstr;
using testing::Not;

TEST(TrustSection, StatesConsequenceAndRemedyOnceEach) {
  const PageWarnings warnings(
      {pipeline::with_remedy({"frac", "the modes explain 98 % < 99 %"}, "take more hits"), {"reversed", "accel 2"}}, {},
      {});
  const std::string html = warnings.section();
  EXPECT_THAT(html, HasSubstr("How far can this test be trusted?"));
  EXPECT_THAT(html, HasSubstr("<li class=\"warn\"><b>Results may be off.</b> the modes explain 98 % &lt; 99 %. "
                              "<span class=\"remedy\">Remedy: take more hits.</span></li>"));
  EXPECT_LT(html.find("accel 2"), html.find("the modes explain")) << "most serious first";
  EXPECT_EQ(html.find("take more hits"), html.rfind("take more hits"));
}

// Split modes are a result themselves and put no other result in doubt.
TEST(TrustSection, CallsSplitModesAPropertyOfTheStructure) {
  const std::string html = PageWarnings({{"double_peak", "split modes: 1900 Hz"}}, {}, {}).section();
  EXPECT_THAT(html, HasSubstr("<b>A property of the structure.</b> split modes: 1900 Hz"));
  EXPECT_THAT(html, Not(HasSubstr("may be off")));
}

TEST(TrustSection, LeavesWarningsToThePartThatTheyConcern) {
  const PageWarnings warnings({{"frac", "of the fit"}, {"reversed", "wrong"}, {"moving_modes", "of all"}}, {},
                              {PagePart::fit, PagePart::force});
  EXPECT_THAT(warnings.beside(PagePart::fit), HasSubstr("of the fit"));
  EXPECT_EQ(warnings.beside(PagePart::force), "");
  const std::string section = warnings.section();
  EXPECT_THAT(section, Not(HasSubstr("of the fit")));
  EXPECT_THAT(section, testing::AllOf(HasSubstr("wrong"), HasSubstr("of all"), HasSubstr("the fit (1)")));
}

TEST(TrustSection, KeepsWrongResultsOnTop) {
  const PageWarnings warnings({{"response_clipped", "clipped"}}, {}, {PagePart::response});
  EXPECT_THAT(warnings.section(), HasSubstr("clipped"));
  EXPECT_EQ(warnings.beside(PagePart::response), "");
}

// The head of a page states modes and their types. Where they are wrong, a caution stands there.
TEST(TrustSection, CautionsTheHeadOfThePageWhereResultsAreWrong) {
  EXPECT_THAT(PageWarnings({{"reversed", "accel 2"}}, {}, {}).caution(),
              HasSubstr("Some of these results are wrong; <a href=\"#trust\">the reason</a>"));
  EXPECT_EQ(PageWarnings({{"frac", "of the fit"}, {"double_peak", "split"}}, {}, {}).caution(), "");
  EXPECT_EQ(PageWarnings({}, {}, {}).caution(), "");
}

TEST(TrustSection, SaysThatNothingWasFound) {
  EXPECT_THAT(PageWarnings({}, {}, {}).section(), HasSubstr("Nothing was found that puts"));
}

}  // namespace percuss::report::trust_section_test
