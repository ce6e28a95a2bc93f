#include "identify/shapes/mode_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/random_stream.hpp"

namespace percuss::identify::mode_shapes_test {

constexpr double kRounding = 1e-12;

// A_pc = φ_p φ_c with standard deviations.
Mode mode_of(const std::vector<Complex>& points, const std::vector<Complex>& sensors, double std = 1e-3) {
  Mode mode{.pole = {1000, 0.005}};
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t c = 0; c < sensors.size(); ++c)
      mode.residues.push_back({.point = p, .channel = c, .value = points[p] * sensors[c], .std = std});
  }
  return mode;
}

TEST(Shape, IsOneAtItsLargestComponentWithoutADrivingPoint) {
  const ModeShape shape = shape_of(mode_of({0.3, -1.2, 0.6}, {-2.0}));
  EXPECT_EQ(shape.normalisation, Normalisation::largest_one);
  ASSERT_EQ(shape.places.size(), 3U);
  EXPECT_NEAR(std::abs(shape.places[0].value - Complex(-0.25)), 0, kRounding);
  EXPECT_NEAR(std::abs(shape.places[1].value - Complex(1)), 0, kRounding);
  EXPECT_NEAR(std::abs(shape.places[2].value - Complex(-0.5)), 0, kRounding);
  EXPECT_FALSE(shape.modal_mass_kg);
}

TEST(Shape, HasUnitModalMassWithADrivingPoint) {
  // A_pp = φ_p²: the result is the shape, positive at the driving point.
  const std::vector<Complex> phi{0.3, -1.2, 0.6};
  const ModeShape shape = shape_of(mode_of(phi, {phi[1]}), {.driving = {{.point = 1, .channel = 0}}});
  EXPECT_EQ(shape.normalisation, Normalisation::unit_modal_mass);
  for (std::size_t p = 0; p < phi.size(); ++p) EXPECT_NEAR(std::abs(shape.places[p].value + phi[p]), 0, kRounding);
  ASSERT_TRUE(shape.modal_mass_kg);
  EXPECT_NEAR(*shape.modal_mass_kg, 1 / (1.2 * 1.2), kRounding);
}

// The hammer strikes along −z where the sensor measures along +z: A_dd = −φ_d².
TEST(Shape, HasUnitModalMassWhereForceAndSensorAreOpposite) {
  const std::vector<Complex> phi{0.3, -1.2, 0.6};
  const Mode mode = mode_of(phi, {-phi[1]});
  EXPECT_FALSE(shape_of(mode, {.driving = {{.point = 1, .channel = 0}}}).modal_mass_kg);
  const ModeShape shape = shape_of(mode, {.driving = {{.point = 1, .channel = 0, .sign = -1}}});
  for (std::size_t p = 0; p < phi.size(); ++p) EXPECT_NEAR(std::abs(shape.places[p].value + phi[p]), 0, kRounding);
  EXPECT_NEAR(std::abs(shape.sensors[0].value - phi[1]), 0, kRounding);
  EXPECT_NEAR(shape.modal_mass_kg.value_or(0), 1 / (1.2 * 1.2), kRounding);
}

TEST(Shape, SeparatesTheStandardDeviationOfTheScale) {
  // δφ/φ = ½ δA/A
  const ModeShape shape = shape_of(mode_of({2.0, 1.0}, {2.0}, 0.04), {.driving = {{.point = 0, .channel = 0}}});
  EXPECT_NEAR(shape.scale_std, 0.5 * 0.04 / 4, kRounding);
  EXPECT_NEAR(shape.places[1].std, 0.04 / 2, kRounding);
}

TEST(Shape, MultipliesBackToTheResidues) {
  const std::vector<Complex> phi{{0.3, 0.01}, -1.2, 0.6, {0.9, -0.02}}, sensors{-1.2, {0.5, 0.03}};
  const Mode mode = mode_of(phi, sensors);
  for (const auto& driving : {std::vector<DrivingPoint>{}, {{.point = 1, .channel = 0}}}) {
    const ModeShape shape = shape_of(mode, {.driving = driving});
    ASSERT_EQ(shape.sensors.size(), 2U);
    for (const Residue& r : mode.residues) {
      const Complex back = shape.places[r.point].value * shape.sensors[r.channel].value;
      EXPECT_NEAR(std::abs(back - r.value), 0, kRounding) << r.point << " " << r.channel;
    }
  }
}

TEST(Shape, TreatsEveryPositionOfARovingSensorAsAPlace) {
  const Mode mode = mode_of({0.5, 1.0}, {1.0, -2.0});
  const ModeShape shape = shape_of(mode, {.roving = Roving::sensor});
  ASSERT_EQ(shape.places.size(), 4U);
  EXPECT_EQ(shape.places[3].point, 1U);
  EXPECT_EQ(shape.places[3].channel, 1U);
  EXPECT_NEAR(std::abs(shape.places[3].value - Complex(1)), 0, kRounding);
  EXPECT_NEAR(std::abs(shape.places[2].value - Complex(-0.5)), 0, kRounding);
}

TEST(Shape, WeightsTheBetterSensor) {
  constexpr double kWithin = 3;  // standard deviations
  Mode mode = mode_of({1.0, 0.5, -0.7, 0.2}, {1.0, 1.0}, 0);
  std::vector<double> noise(2 * mode.residues.size());
  synth::RandomStream({3, 3}).add_normal(1, noise);
  for (std::size_t i = 0; i < mode.residues.size(); ++i) {
    Residue& r = mode.residues[i];
    r.std = r.channel == 0 ? 1e-4 : 0.1;
    r.value += r.std * Complex(noise[2 * i], noise[2 * i + 1]);
  }
  const ModeShape shape = shape_of(mode);
  EXPECT_LE(std::abs(shape.places[1].value - Complex(0.5)), kWithin * 2e-4);
  EXPECT_LE(shape.places[1].std, 2e-4);
}

TEST(Shape, DoesNotDependOnTheUnit) {
  Mode mode = mode_of({0.3, {-1.2, 0.2}, 0.6}, {1.0, 0.4});
  const ModeShape before = shape_of(mode);
  for (Residue& r : mode.residues) {
    r.value *= Complex(0, -1e6);
    r.std *= 1e6;
  }
  const ModeShape after = shape_of(mode);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(std::abs(before.places[p].value - after.places[p].value), 0, kRounding);
    EXPECT_NEAR(before.places[p].std, after.places[p].std, kRounding);
  }
  EXPECT_NEAR(before.significance, after.significance, kRounding * before.significance);
}

TEST(Shape, IncludesTheForcesNoiseInItsStandardDeviations) {
  Mode mode = mode_of({1.0, 0.5}, {1.0}, 0.003);
  mode.residues[1].relative_std = 0.008;  // 0.004 of the value 0.5
  EXPECT_NEAR(shape_of(mode).places[1].std, 0.005, kRounding);
}

TEST(Shape, IsNotScaledByADrivingPointAtANode) {
  const ModeShape shape = shape_of(mode_of({1.0, 1e-4}, {0.01}), {.driving = {{.point = 1, .channel = 0}}});
  EXPECT_EQ(shape.normalisation, Normalisation::largest_one);
  EXPECT_FALSE(shape.modal_mass_kg);
}

TEST(PhaseCollinearity, IsOneForARealShapeAtAnyPhase) {
  EXPECT_NEAR(shape_of(mode_of({0.3, -1.2, 0.6}, {{0.4, 0.9}})).mpc, 1, kRounding);
}

TEST(PhaseCollinearity, IsZeroForATravellingWave) {
  EXPECT_NEAR(shape_of(mode_of({1, {0, 1}, -1, {0, -1}}, {1.0})).mpc, 0, kRounding);
}

TEST(ShapeSignificance, IsAboutOneForNoiseAndLargeForAMode) {
  EXPECT_NEAR(shape_of(mode_of({{1e-3, 1e-3}, {1e-3, -1e-3}}, {1.0}, 1e-3)).significance, 1, kRounding);
  EXPECT_GT(shape_of(mode_of({1, -1}, {1.0}, 1e-3)).significance, 100);
}

TEST(Shape, AcceptsAZeroMode) {
  const ModeShape none = shape_of(mode_of({0, 0}, {0, 0}));
  for (const ShapePlace& place : none.places) EXPECT_EQ(place.value, Complex());
  EXPECT_EQ(none.mpc, 0);
  EXPECT_TRUE(shape_of({}).places.empty());
}

}  // namespace percuss::identify::mode_shapes_test
