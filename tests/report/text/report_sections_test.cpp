#include "report/text/report_sections.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace percuss::sections_test {

TEST(ParseSections, KnowsEveryOneByName) {
  EXPECT_EQ(parse_sections({"hits", "frf", "coherence", "modes", "classes"}), all_sections());
  EXPECT_EQ(parse_sections({"frf", "frf"}), std::set{Section::frf});
  EXPECT_TRUE(parse_sections({}).empty());
}

TEST(ParseSections, RefusesOthers) { EXPECT_THROW(parse_sections({"hits", "Modes"}), UsageError); }

}  // namespace percuss::sections_test
