#include "model/beam/laminate.hpp"

#include <gtest/gtest.h>

namespace percuss::model::laminate_test {

constexpr double kRounding = 1e-12;  // of a few operations on values of about 1

TEST(Laminate, SumsItsLayersAboutTheNeutralAxis) {
  // One material in layers is the solid section E b h³/12.
  const auto solid = laminate_section({{.young_Pa = 7e10, .width_m = 0.1, .height_m = 0.002, .density_kgpm3 = 2700},
                                       {.young_Pa = 7e10, .width_m = 0.1, .height_m = 0.005, .density_kgpm3 = 2700},
                                       {.young_Pa = 7e10, .width_m = 0.1, .height_m = 0.003, .density_kgpm3 = 2700}});
  EXPECT_NEAR(solid.stiffness_Nm2 / (7e10 * 0.1 * 1e-6 / 12), 1, kRounding);
  EXPECT_NEAR(solid.mass_per_length_kgpm, 2700 * 0.1 * 0.01, kRounding);
  EXPECT_NEAR(solid.neutral_axis_m, 0.005, kRounding);
  // A sandwich: two faces t = 2 mm, 22 mm apart, and a core of 20 mm.
  const LaminateLayer face{.young_Pa = 7e10, .width_m = 0.1, .height_m = 0.002};
  const auto sandwich = laminate_section({face, {.young_Pa = 1e9, .width_m = 0.1, .height_m = 0.02}, face});
  const double by_hand = 2 * 7e10 * 0.1 * (8e-9 / 12 + 0.002 * 0.011 * 0.011) + 1e9 * 0.1 * 8e-6 / 12;
  EXPECT_NEAR(sandwich.stiffness_Nm2 / by_hand, 1, kRounding);
}

}  // namespace percuss::model::laminate_test
