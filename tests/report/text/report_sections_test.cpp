#include "report/text/report_sections.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace percuss::report::report_sections_test {

TEST(ParseSections, KnowsEachSectionByName) {
  EXPECT_EQ(parse_report_sections({"hits", "frf", "coherence", "modes", "classes"}), default_sections());
  EXPECT_EQ(parse_report_sections({"frf", "frf"}), std::set{ReportSection::frf});
  EXPECT_TRUE(parse_report_sections({}).empty());
}

TEST(ParseSections, RefusesOthers) { EXPECT_THROW(parse_report_sections({"hits", "Modes"}), UsageError); }

}  // namespace percuss::report::report_sections_test
