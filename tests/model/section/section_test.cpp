#include "model/section/section.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "model/section/section_table.hpp"

namespace percuss::model::section_test {

using std::numbers::pi;

constexpr double kRounding = 1e-14;  // relative, of a sum of a few terms
const Material kWood;

void expect_equal(const BeamSection& a, const BeamSection& b) {
  EXPECT_NEAR(a.bending_Nm2, b.bending_Nm2, kRounding * b.bending_Nm2);
  EXPECT_NEAR(a.shear_N, b.shear_N, kRounding * b.shear_N);
  EXPECT_NEAR(a.mass_kgpm, b.mass_kgpm, kRounding * b.mass_kgpm);
  EXPECT_NEAR(a.rotary_kgm, b.rotary_kgm, kRounding * b.rotary_kgm);
}

TEST(RoundSection, OfASolidRodHasTheClosedForm) {
  const double d = 0.06, area = pi * d * d / 4, second = pi * d * d * d * d / 64;
  expect_equal(round_section(d, {{}}, kWood), {.bending_Nm2 = kWood.young_Pa * second,
                                               .shear_N = kWood.shear_Pa * area,
                                               .mass_kgpm = kWood.density_kgpm3 * area,
                                               .rotary_kgm = kWood.density_kgpm3 * second});
}

TEST(RoundSection, OfATubeIsTheRodWithoutItsCore) {
  const BeamSection tube = round_section(0.066, {{.thickness_m = 0.003}}, kWood);
  const BeamSection rod = round_section(0.066, {{}}, kWood), core = round_section(0.060, {{}}, kWood);
  expect_equal(tube, {.bending_Nm2 = rod.bending_Nm2 - core.bending_Nm2,
                      .shear_N = rod.shear_N - core.shear_N,
                      .mass_kgpm = rod.mass_kgpm - core.mass_kgpm,
                      .rotary_kgm = rod.rotary_kgm - core.rotary_kgm});
}

// Two layers are a tube of the first material and a rod of the second.
TEST(RoundSection, AddsItsLayers) {
  const SectionLayer shell{.thickness_m = 0.004, .density_kgpm3 = 2700, .young_Pa = 7e10, .shear_Pa = 1.3e10};
  const SectionLayer foam{.density_kgpm3 = 100, .young_Pa = 1e8, .shear_Pa = 3e7};
  const BeamSection both = round_section(0.066, {shell, foam}, kWood);
  const BeamSection tube = round_section(0.066, {shell}, kWood), core = round_section(0.058, {foam}, kWood);
  expect_equal(both, {.bending_Nm2 = tube.bending_Nm2 + core.bending_Nm2,
                      .shear_N = tube.shear_N + core.shear_N,
                      .mass_kgpm = tube.mass_kgpm + core.mass_kgpm,
                      .rotary_kgm = tube.rotary_kgm + core.rotary_kgm});
}

TEST(RoundSection, EndsAtTheAxis) {
  expect_equal(round_section(0.05, {{.thickness_m = 0.025}}, kWood), round_section(0.05, {{}}, kWood));
  expect_equal(round_section(0.05, {{}, {.thickness_m = 0.01}}, kWood), round_section(0.05, {{}}, kWood));
}

TEST(RectangularSection, OfEqualLayersIsOneBlock) {
  const double b = 0.1, h = 0.04;
  const BeamSection block{.bending_Nm2 = kWood.young_Pa * b * h * h * h / 12,
                          .shear_N = kWood.shear_Pa * b * h,
                          .mass_kgpm = kWood.density_kgpm3 * b * h,
                          .rotary_kgm = kWood.density_kgpm3 * b * h * h * h / 12};
  expect_equal(rectangular_section(b, {{.thickness_m = h}}, kWood), block);
  expect_equal(rectangular_section(b, {{.thickness_m = 0.01}, {.thickness_m = 0.03}}, kWood), block);
}

// A sandwich of thin faces about a light core: the faces' parallel-axis terms and their own.
TEST(RectangularSection, OfASandwichHasItsClosedForm) {
  const double b = 0.05, t = 0.002, core = 0.02;
  const SectionLayer face{.thickness_m = t, .density_kgpm3 = 1600, .young_Pa = 1e11, .shear_Pa = 4e9};
  const SectionLayer foam{.thickness_m = core, .density_kgpm3 = 80, .young_Pa = 6e7, .shear_Pa = 2e7};
  const BeamSection s = rectangular_section(b, {face, foam, face}, kWood);
  const double arm = (core + t) / 2, faces = 2 * b * (t * t * t / 12 + t * arm * arm),
               middle = b * core * core * core / 12;
  expect_equal(s, {.bending_Nm2 = 1e11 * faces + 6e7 * middle,
                   .shear_N = b * (2 * t * 4e9 + core * 2e7),
                   .mass_kgpm = b * (2 * t * 1600 + core * 80),
                   .rotary_kgm = 1600 * faces + 80 * middle});
}

TEST(SectionTable, TakesSlicesConstantAndPointsLinear) {
  SectionTable table{.kind = ProfileKind::slices,
                     .stations = {{.at_m = 0.2, .width_m = 0.03, .layers = {{.thickness_m = 0.002}}},
                                  {.at_m = 0.6, .width_m = 0.05, .layers = {{.thickness_m = 0.004}}}}};
  const auto tube = [](double diameter_m, double wall_m) {
    return round_section(diameter_m, {{.thickness_m = wall_m}}, kWood);
  };
  expect_equal(section_at(table, kWood, 1, 0.3), tube(0.05, 0.004));
  table.kind = ProfileKind::points;
  expect_equal(section_at(table, kWood, 0, 0.1), tube(0.03, 0.002));  // before the first point
  expect_equal(section_at(table, kWood, 1, 0.3), tube(0.035, 0.0025));
  expect_equal(section_at(table, kWood, 1, 0.6), tube(0.05, 0.004));
  EXPECT_NEAR(table.longest_fraction(), 2.0 / 3, kRounding);
}

}  // namespace percuss::model::section_test
