#include "core/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"

namespace percuss::units_test {

// Products of exact constants: one rounding each.
constexpr double kRounding = 4e-16;

struct Case {
  const char* name;
  Quantity quantity;
  double to_SI;
};

class Units : public testing::TestWithParam<Case> {};

TEST_P(Units, AreParsedAsInstrumentsWriteThem) {
  const auto unit = parse_unit(GetParam().name);
  ASSERT_TRUE(unit) << GetParam().name;
  EXPECT_EQ(unit->quantity, GetParam().quantity) << GetParam().name;
  EXPECT_NEAR(unit->to_SI / GetParam().to_SI, 1, kRounding) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(Force, Units,
                         testing::Values(Case{"N", Quantity::force, 1}, Case{"kN", Quantity::force, 1000},
                                         Case{"mN", Quantity::force, 0.001}, Case{"[N]", Quantity::force, 1},
                                         Case{" ( N ) ", Quantity::force, 1},
                                         Case{"lbf", Quantity::force, 4.4482216152605},
                                         Case{"kgf", Quantity::force, 9.80665}));

INSTANTIATE_TEST_SUITE_P(
    Acceleration, Units,
    testing::Values(Case{"m/s^2", Quantity::acceleration, 1}, Case{"m/s2", Quantity::acceleration, 1},
                    Case{"m/s\xC2\xB2", Quantity::acceleration, 1}, Case{"m/s\xB2", Quantity::acceleration, 1},
                    Case{"(m/s2)", Quantity::acceleration, 1}, Case{"m/s/s", Quantity::acceleration, 1},
                    Case{"m/s**2", Quantity::acceleration, 1}, Case{"m*s^-2", Quantity::acceleration, 1},
                    Case{"m\xC2\xB7s\xE2\x81\xBB\xC2\xB2", Quantity::acceleration, 1},
                    Case{"m_s2", Quantity::acceleration, 1}, Case{"mps2", Quantity::acceleration, 1},
                    Case{"m/(s^2)", Quantity::acceleration, 1}, Case{"mm/s^2", Quantity::acceleration, 0.001},
                    Case{"cm/s2", Quantity::acceleration, 0.01}, Case{"in/s^2", Quantity::acceleration, 0.0254},
                    Case{"ft/s^2", Quantity::acceleration, 0.3048}, Case{"g", Quantity::acceleration, 9.80665},
                    Case{"mg", Quantity::acceleration, 0.00980665}));

INSTANTIATE_TEST_SUITE_P(Others, Units,
                         testing::Values(Case{"V", Quantity::voltage, 1}, Case{"mV", Quantity::voltage, 0.001},
                                         Case{"s", Quantity::time, 1}, Case{"ms", Quantity::time, 0.001},
                                         Case{"us", Quantity::time, 1e-6}, Case{"\xC2\xB5s", Quantity::time, 1e-6},
                                         Case{"\xCE\xBCs", Quantity::time, 1e-6}, Case{"\xB5s", Quantity::time, 1e-6},
                                         Case{"deg", Quantity::angle, std::numbers::pi / 180},
                                         Case{"\xC2\xB0", Quantity::angle, std::numbers::pi / 180},
                                         Case{"rad", Quantity::angle, 1}, Case{"m", Quantity::length, 1},
                                         Case{"mm", Quantity::length, 0.001}, Case{"cm", Quantity::length, 0.01},
                                         Case{"in", Quantity::length, 0.0254}, Case{"kg", Quantity::mass, 1},
                                         Case{"lbs", Quantity::mass, 0.45359237}, Case{"m/s", Quantity::velocity, 1},
                                         Case{"mm_s", Quantity::velocity, 0.001}));

TEST(ParseUnit, ReturnsNothingForUnknownUnits) {
  for (const char* name :
       {"", " ", "furlong", "Mg", "MG", "N/m", "()", "m/s^3", "1", "kHz", "s2", "^", "((((((((((((((((((((((((("}) {
    EXPECT_FALSE(parse_unit(name)) << name;
  }
}

TEST(RequireUnit, NamesTheQuantityOfAWrongUnit) {
  try {
    require_unit("g", Quantity::force, "x.csv: column 2");
    FAIL() << "an acceleration passed for a force";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "\"g\" measures an acceleration, not a force (x.csv: column 2); use N, kN, lbf or kgf");
  }
}

TEST(SiName, IsParsedAsFactorOne) {
  for (const auto quantity : {Quantity::force, Quantity::acceleration, Quantity::voltage, Quantity::time,
                              Quantity::angle, Quantity::length, Quantity::mass}) {
    const auto unit = parse_unit(si_name(quantity));
    ASSERT_TRUE(unit);
    EXPECT_EQ(unit->quantity, quantity);
    EXPECT_EQ(unit->to_SI, 1);
  }
}

}  // namespace percuss::units_test
