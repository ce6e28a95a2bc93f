#include "synth/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percuss::synth::structure_test {

using std::numbers::pi;

TEST(FreeBeam, IsOneAtBothEndsUpToItsSymmetry) {
  constexpr double kTolerance = 1e-12;  // rounding: the arguments are up to 159
  for (int n = 1; n <= 50; ++n) {
    EXPECT_LE(std::abs(free_beam_shape(n, 0) - 1), kTolerance) << n;
    EXPECT_LE(std::abs(free_beam_shape(n, 1) - (n % 2 == 1 ? 1 : -1)), kTolerance) << n;
    EXPECT_LE(std::abs(free_beam_shape(n, 0.3) - (n % 2 == 1 ? 1 : -1) * free_beam_shape(n, 0.7)), kTolerance) << n;
  }
}

TEST(FreeBeam, HasTheTextbookNodes) {
  constexpr double kTolerance = 5.5e-4;  // half of the fourth digit times a slope of up to β = 11
  EXPECT_LE(std::abs(free_beam_shape(1, 0.2242)), kTolerance);
  EXPECT_LE(std::abs(free_beam_shape(2, 0.1321)), kTolerance);
  EXPECT_LE(std::abs(free_beam_shape(3, 0.0944)), kTolerance);
}

TEST(FreeBeam, ShapesAreOrthogonalToEachOtherAndToRigidMotion) {
  constexpr int kSteps = 20000;
  constexpr double kTolerance = 1e-6;  // trapezoidal rule with (β/20000)²/12 at the highest shape
  const auto product = [](const auto& f, const auto& g) {
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double x = static_cast<double>(i) / kSteps;
      sum += (i == 0 || i == kSteps ? 0.5 : 1.0) * f(x) * g(x) / kSteps;
    }
    return sum;
  };
  for (const int n : {1, 2, 3, 12}) {
    const auto shape = [n](double x) { return free_beam_shape(n, x); };
    EXPECT_LE(std::abs(product(shape, [](double) { return 1.0; })), kTolerance);
    EXPECT_LE(std::abs(product(shape, [](double x) { return x; })), kTolerance);
    EXPECT_LE(std::abs(product(shape, [](double x) { return free_beam_shape(4, x); })), kTolerance);
    EXPECT_LE(std::abs(product(shape, shape) - 0.25), kTolerance);  // a shape of 1 at the tip has ∫X² = 1/4
  }
}

SynthSpec bat() {
  SynthSpec spec;
  spec.modes = {{.freq_Hz = 200, .damping_ratio = 0.01, .angle_rad = 0.35},
                {.freq_Hz = 2100, .damping_ratio = 0.003, .type = SynthModeType::hoop, .angle_rad = 0.2}};
  spec.sensors = {{.angle_rad = 0.1}, {.angle_rad = 0.1 + pi / 2}};
  spec.points = {{.angle_rad = 0.3}};
  return spec;
}

TEST(Residue, HasTheRatioOfItsModeTypeForSensorsAtARightAngle) {
  const SynthSpec spec = bat();
  constexpr double kTolerance = 1e-14;  // rounding
  EXPECT_LE(std::abs(residue_per_kg(spec, 1, 0, 1) / residue_per_kg(spec, 1, 0, 0) + 1), kTolerance);
  EXPECT_LE(std::abs(residue_per_kg(spec, 0, 0, 1) / residue_per_kg(spec, 0, 0, 0) - std::tan(0.35 - 0.1)), kTolerance);
}

TEST(Residue, IsReciprocal) {
  SynthSpec spec = bat();
  spec.sensors = {{.position_m = 0.05, .angle_rad = 0.4}};
  spec.points = {{.position_m = 0.21, .angle_rad = 1.3}};
  const double there = residue_per_kg(spec, 0, 0, 0), rigid = rigid_line_per_kg(spec, 0, 0);
  spec.sensors = {{.position_m = 0.21, .angle_rad = 1.3}};
  spec.points = {{.position_m = 0.05, .angle_rad = 0.4}};
  EXPECT_DOUBLE_EQ(residue_per_kg(spec, 0, 0, 0), there);
  EXPECT_DOUBLE_EQ(rigid_line_per_kg(spec, 0, 0), rigid);
}

TEST(Residue, IncludesSignAndGains) {
  SynthSpec spec = bat();
  const double plain = residue_per_kg(spec, 0, 0, 0);
  spec.sensors[0].sign = -1;
  spec.sensors[0].gain = 0.98;
  spec.recorder.force_gain = 1.1;
  EXPECT_DOUBLE_EQ(residue_per_kg(spec, 0, 0, 0), -plain * 0.98 / 1.1);
}

TEST(HoopShape, VanishesAtTheEndCapAndBeyondTheBarrel) {
  const SynthSpec spec = bat();
  EXPECT_EQ(mode_shape_per_sqrt_kg(spec.structure, spec.modes[1], 0, 0), 0);
  EXPECT_EQ(mode_shape_per_sqrt_kg(spec.structure, spec.modes[1], 0.5, 0), 0);
  EXPECT_DOUBLE_EQ(mode_shape_per_sqrt_kg(spec.structure, spec.modes[1], spec.structure.barrel_m / 2, 0.2), 1);
}

TEST(RigidLine, IsOneOverTheMassAtTheCentreOfMass) {
  SynthSpec spec = bat();
  spec.points = {{.position_m = spec.structure.cm_m, .angle_rad = 0.1}};
  EXPECT_DOUBLE_EQ(rigid_line_per_kg(spec, 0, 0), 1 / spec.structure.mass_kg);
}

}  // namespace percuss::synth::structure_test
