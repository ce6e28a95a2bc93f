#include "model/shell/shell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/shell/shell_fit.hpp"
#include "support/input_error.hpp"

namespace percuss::model::shell_test {

const TubeShell kAluminium;  // 70 GPa, 2700 kg/m³, 0.33; 2.625 in by 0.100 in, 13 in long

// Independently computed figures, to 1 Hz.
TEST(Shell, ReproducesFiguresRoundedToOneHertz) {
  EXPECT_NEAR(ring_Hz(kAluminium, 2), 1550, 0.5);
  EXPECT_NEAR(flugge_Hz(kAluminium, 2, 1), 1756, 0.5);
}

// The same formulas computed by numpy, to rounding.
TEST(Shell, ReproducesIndependentFigures) {
  constexpr double kRounding = 1e-9;
  EXPECT_NEAR(ring_Hz(kAluminium, 2), 1550.4808426018976, kRounding);
  EXPECT_NEAR(rayleigh_Hz(kAluminium, 2), 1642.4916966269188, kRounding);
  EXPECT_NEAR(love_Hz(kAluminium, 2), 1668.6243473459517, kRounding);
  EXPECT_NEAR(flugge_Hz(kAluminium, 2, 1), 1755.9281588664942, kRounding);
  EXPECT_NEAR(flugge_Hz(kAluminium, 2, 2), 2623.5987466791744, kRounding);
  EXPECT_NEAR(flugge_Hz(kAluminium, 3, 1), 4697.463016394883, kRounding);
}

// Three-dimensional elasticity of the tube between diaphragms: Ritz's method with ten Legendre polynomials through the
// wall, cos nθ and sin mπx/L exact (numpy and scipy's eigh). Flügge's equations leave out terms that vanish with h/R:
// the excess falls from 0.52 % (n = 2) and 1 % (n = 3) to 0.021 % and 0.04 % for a tenth of the wall.
TEST(Shell, IsNearThreeDimensionalElasticity) {
  struct Known {
    std::size_t n, m;
    double solid_Hz;
  };
  for (const auto& [n, m, solid_Hz] : std::vector<Known>{{2, 1, 1746.91506332},
                                                         {2, 2, 2609.32715809},
                                                         {2, 3, 4351.52912124},
                                                         {3, 1, 4655.44442555},
                                                         {3, 2, 4875.73652271}}) {
    const double excess = flugge_Hz(kAluminium, n, m) / solid_Hz - 1;
    EXPECT_GT(excess, 0) << n << m;
    EXPECT_LT(excess, 0.0105) << n << m;
  }
  TubeShell thin = kAluminium;
  thin.wall_m /= 10;
  EXPECT_NEAR(flugge_Hz(thin, 2, 1), 552.1615915, 3e-4 * 552);  // the excess is 2.1e-4, as stated above
  EXPECT_NEAR(flugge_Hz(thin, 3, 1), 505.8012237, 5e-4 * 506);
}

TEST(Shell, AgreesWithRayleighAndLoveWhenLong) {
  TubeShell tube = kAluminium;
  tube.length_m = 1000;
  constexpr double kLong = 1e-6, kThin = 5.3e-4;  // h²/12R²: Rayleigh's tube does not stretch at all
  for (const std::size_t n : {2U, 3U, 5U}) {
    EXPECT_NEAR(flugge_Hz(tube, n, 1) / rayleigh_Hz(tube, n), 1, kThin);
    EXPECT_NEAR(love_Hz(tube, n) / rayleigh_Hz(tube, n), 1, kLong);
  }
  tube.poisson = 0;
  EXPECT_DOUBLE_EQ(ring_Hz(tube, 2), rayleigh_Hz(tube, 2));
}

// Donnell's equations contain k n⁴ in place of k (n² − 1)², which makes the frequency for n = 2 a third too high.
TEST(Shell, DiffersFromDonnell) {
  TubeShell tube = kAluminium;
  tube.length_m = 1000;
  EXPECT_LT(flugge_Hz(tube, 2, 1), 1.01 * rayleigh_Hz(tube, 2));
}

TEST(Shell, IsProportionalToTheRootOfItsModulus) {
  TubeShell stiff = kAluminium;
  stiff.young_Pa *= 4;
  EXPECT_NEAR(flugge_Hz(stiff, 3, 2), 2 * flugge_Hz(kAluminium, 3, 2), 1e-9);
}

// Outer less inner cylinder.
TEST(Shell, HasTheMassOfItsMaterial) {
  const double outer = kAluminium.outer_diameter_m, inner = outer - 2 * kAluminium.wall_m;
  EXPECT_NEAR(tube_mass_kg(kAluminium),
              kAluminium.density_kgpm3 * std::numbers::pi / 4 * (outer * outer - inner * inner) * kAluminium.length_m,
              1e-12);
}

std::vector<MeasuredHoop> measured_on(const TubeShell& shell, std::vector<MeasuredHoop> patterns) {
  for (auto& hoop : patterns) {
    hoop.freq_Hz = flugge_Hz(shell, hoop.n, hoop.m);
    hoop.freq_std_Hz = 1e-3 * hoop.freq_Hz;
  }
  return patterns;
}

TEST(ShellFit, RecoversTheModulus) {
  TubeShell truth = kAluminium;
  truth.young_Pa = 61e9;
  const ShellFit fit = fit_shell(kAluminium, measured_on(truth, {{.n = 2, .m = 1}}), ShellUnknowns::young);
  EXPECT_NEAR(fit.shell.young_Pa, 61e9, 1e3);
  EXPECT_NEAR(fit.young_std_Pa, 2e-3 * 61e9, 1e3);  // f goes like √E
  EXPECT_EQ(fit.wall_std_m, 0);
}

TEST(ShellFit, RecoversTheWall) {
  TubeShell truth = kAluminium;
  truth.wall_m = 0.0021;
  const ShellFit fit =
      fit_shell(kAluminium, measured_on(truth, {{.n = 2, .m = 1}, {.n = 3, .m = 1}}), ShellUnknowns::wall);
  EXPECT_NEAR(fit.shell.wall_m, 0.0021, 1e-10);
  EXPECT_GT(fit.wall_std_m, 0);
}

TEST(ShellFit, RecoversBothFromPatternsThatStretchTheWallDifferently) {
  TubeShell truth = kAluminium;
  truth.wall_m = 0.0021;
  truth.young_Pa = 61e9;
  const ShellFit fit = fit_shell(kAluminium, measured_on(truth, {{.n = 2, .m = 1}, {.n = 2, .m = 3}, {.n = 3, .m = 1}}),
                                 ShellUnknowns::both);
  EXPECT_NEAR(fit.shell.wall_m, 0.0021, 1e-9);
  EXPECT_NEAR(fit.shell.young_Pa, 61e9, 1e5);
  EXPECT_LT(fit.chi2, 1e-9);
  EXPECT_LT(fit.correlation, -0.5);
}

TEST(ShellFit, EnlargesStandardDeviationsThatTheMisfitExceeds) {
  auto measured = measured_on(kAluminium, {{.n = 2, .m = 1}, {.n = 3, .m = 1}});
  const double stated_Pa = fit_shell(kAluminium, measured, ShellUnknowns::young).young_std_Pa;
  measured[0].freq_Hz *= 1.01;
  measured[1].freq_Hz *= 0.99;
  const ShellFit fit = fit_shell(kAluminium, measured, ShellUnknowns::young);
  ASSERT_GT(fit.chi2, 30);
  constexpr double kFrequenciesChanged = 0.03;
  EXPECT_NEAR(fit.young_std_Pa / stated_Pa / std::sqrt(fit.chi2), 1, kFrequenciesChanged);
}

// Every frequency of a long tube is proportional to h √E.
TEST(ShellFit, RefusesPatternsThatDoNotSeparateTheUnknowns) {
  TubeShell tube = kAluminium;
  tube.length_m = 5;
  const auto alike = measured_on(tube, {{.n = 2, .m = 1}, {.n = 3, .m = 1}});
  EXPECT_THAT(test::input_error_of([&] { fit_shell(tube, alike, ShellUnknowns::both); }),
              testing::HasSubstr("separate"));
  EXPECT_THAT(test::input_error_of([&] { fit_shell(tube, {alike[0]}, ShellUnknowns::both); }),
              testing::HasSubstr("two frequencies"));
}

// For a single unknown, the message must not advise to fit only one.
TEST(ShellFit, NamesARemedyForOneUnknown) {
  auto uncertain = measured_on(kAluminium, {{.n = 2, .m = 1}});
  uncertain[0].freq_std_Hz = uncertain[0].freq_Hz;
  for (const ShellUnknowns unknowns : {ShellUnknowns::young, ShellUnknowns::wall}) {
    EXPECT_EQ(test::input_error_of([&] { fit_shell(kAluminium, uncertain, unknowns); }),
              "these frequencies are too uncertain for a fit (the measured hoop frequencies); add frequencies, or "
              "measure them more precisely");
  }
}

TEST(ShellFit, RefusesNoFrequency) {
  const auto message = [](ShellUnknowns unknowns) {
    return test::input_error_of([&] { fit_shell(kAluminium, {}, unknowns); });
  };
  EXPECT_THAT(message(ShellUnknowns::young), testing::HasSubstr("E needs a frequency"));
  EXPECT_THAT(message(ShellUnknowns::wall), testing::HasSubstr("the wall needs a frequency"));
  EXPECT_THAT(message(ShellUnknowns::both), testing::HasSubstr("E and wall need two frequencies"));
}

}  // namespace percuss::model::shell_test
