#include "acquire/channels/frf_unit.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"

namespace percuss::acquire::frf_unit_test {

struct Case {
  const char* text;
  FrfKind kind;
  double response_to_SI, force_to_SI;
};

TEST(ParseFrfUnit, ReadsResponseOverForce) {
  for (const Case& c :
       {Case{"(m/s^2)/N", FrfKind::accelerance, 1, 1}, Case{"m/s^2/N", FrfKind::accelerance, 1, 1},
        Case{"m/s\xC2\xB2/N", FrfKind::accelerance, 1, 1}, Case{"g/N", FrfKind::accelerance, kStandardGravity_mps2, 1},
        Case{"g/lbf", FrfKind::accelerance, kStandardGravity_mps2, kPoundForce_N},
        Case{"[(m/s^2)/N]", FrfKind::accelerance, 1, 1}, Case{"((m/s^2)/N)", FrfKind::accelerance, 1, 1},
        Case{"(mm/s)/N", FrfKind::mobility, 1e-3, 1}, Case{"m/s/N", FrfKind::mobility, 1, 1},
        Case{"m/N", FrfKind::receptance, 1, 1}, Case{"mm/kN", FrfKind::receptance, 1e-3, 1e3},
        Case{"um/N", FrfKind::receptance, 1e-6, 1}}) {
    const auto unit = parse_frf_unit(c.text);
    ASSERT_TRUE(unit) << c.text;
    EXPECT_EQ(unit->kind, c.kind) << c.text;
    EXPECT_EQ(unit->response_to_SI, c.response_to_SI) << c.text;
    EXPECT_EQ(unit->force_to_SI, c.force_to_SI) << c.text;
  }
}

TEST(ParseFrfUnit, ReadsBracketsWithoutASlashAsAnalysersWriteThem) {
  for (const char* text : {"(m/s2)(N)", "(m/s\xB2)(N)", "(m/s\xC2\xB2)(N)"}) {
    ASSERT_TRUE(parse_frf_unit(text)) << text;
    EXPECT_EQ(parse_frf_unit(text)->kind, FrfKind::accelerance);
  }
}

TEST(ParseFrfUnit, ReadsNothingElse) {
  for (const char* text : {"", "Hz", "N", "m/s^2", "N/N", "(Hz)", "/", "()", ")(", "(/)", "V/V", "(m/s^2)/", "g/kg"})
    EXPECT_FALSE(parse_frf_unit(text)) << text;
  EXPECT_FALSE(parse_frf_unit(std::string(100000, '(')));
}

TEST(ParseFrfKind, KnowsTheUsualWords) {
  EXPECT_EQ(parse_frf_kind("Accelerance"), FrfKind::accelerance);
  EXPECT_EQ(parse_frf_kind("inertance"), FrfKind::accelerance);
  EXPECT_EQ(parse_frf_kind("mobility"), FrfKind::mobility);
  EXPECT_EQ(parse_frf_kind("RECEPTANCE"), FrfKind::receptance);
  EXPECT_FALSE(parse_frf_kind("impedance"));
}

}  // namespace percuss::acquire::frf_unit_test
