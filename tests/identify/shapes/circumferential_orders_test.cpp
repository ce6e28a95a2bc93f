#include "identify/shapes/circumferential_orders.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::circumferential_orders_test {

using std::numbers::pi;

constexpr double kRounding = 1e-12;
// The confidence of a clear pattern is at least 0.95: the share that an alias of order 3 leaves.
constexpr double kClear = 0.95 - kRounding;

struct Grid {
  int rings = 6, angles = 6;
  double offset_rad = 0;
};

TubeGeometry geometry_of(const Grid& grid) {
  TubeGeometry out;
  for (int r = 0; r < grid.rings; ++r) {
    for (int a = 0; a < grid.angles; ++a) {
      out[static_cast<std::size_t>(r * grid.angles + a)] = {.position_m = 0.05 * r,
                                                            .angle_rad = grid.offset_rad + 2 * pi * a / grid.angles};
    }
  }
  return out;
}

// g(x) cos n(θ − θ₀) at the grid's points.
template <class Axial>
ModeShape pattern(const TubeGeometry& geometry, int n, double plane_rad, Axial&& axial, double noise = 0) {
  ModeShape shape;
  std::vector<double> errors(geometry.size());
  if (noise > 0) synth::RandomStream({1, static_cast<std::uint64_t>(n)}).add_normal(noise, errors);
  for (const auto& [point, place] : geometry) {
    const double value = axial(place.position_m) * std::cos(n * (place.angle_rad - plane_rad));
    shape.places.push_back({.point = point, .value = value + errors[shape.places.size()], .std = noise});
  }
  return shape;
}

double flat(double /*position_m*/) { return 1; }

TEST(TubeShape, FindsTheOrdersThatTheAnglesResolve) {
  for (const int angles : {5, 6, 8, 10}) {
    const TubeGeometry geometry = geometry_of({.angles = angles});
    for (int n = 0; n <= (angles - 1) / 2; ++n) {
      const auto tube = tube_shape(pattern(geometry, n, 0.3, flat), geometry);
      ASSERT_TRUE(tube);
      EXPECT_EQ(tube->order, n) << angles;
      EXPECT_NEAR(tube->energy[static_cast<std::size_t>(n)], 1, kRounding);
      EXPECT_GE(tube->confidence, kClear);
    }
  }
}

TEST(TubeShape, FindsThePlaneAtAnyAngle) {
  const TubeGeometry geometry = geometry_of({.offset_rad = 0.2});
  for (const int n : {1, 2}) {
    for (const double plane_deg : {0.5, 12.0, 57.0, 89.0}) {
      const auto tube = tube_shape(pattern(geometry, n, plane_deg * kDegree_rad, flat), geometry);
      ASSERT_TRUE(tube && tube->plane_rad);
      EXPECT_NEAR(*tube->plane_rad, plane_deg * kDegree_rad, kRounding) << n;
    }
  }
}

TEST(TubeShape, NamesBendingAndHoopOnly) {
  const TubeGeometry geometry = geometry_of({.angles = 8});
  const std::array types{ModeType::unknown, ModeType::bending, ModeType::hoop, ModeType::unknown};
  for (int n = 0; n <= 3; ++n) {
    EXPECT_EQ(mode_type_of(*tube_shape(pattern(geometry, n, 0.3, flat), geometry)), types[static_cast<std::size_t>(n)])
        << n;
  }
}

TEST(TubeShape, ResolvesOnlyTheCosineAtHalfTheNumberOfAngles) {
  // Six angles: cos 3θ alternates, sin 3θ is zero everywhere; its plane is unknown.
  const TubeGeometry geometry = geometry_of({});
  const auto tube = tube_shape(pattern(geometry, 3, 10 * kDegree_rad, flat), geometry);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->order, 3);
  EXPECT_FALSE(tube->plane_rad);
  EXPECT_NEAR(tube->energy[3], 1, kRounding);
}

TEST(TubeShape, StatesTheAlias) {
  const TubeGeometry geometry = geometry_of({});
  EXPECT_EQ(tube_shape(pattern(geometry, 2, 0, flat), geometry)->alias, 4);
  EXPECT_EQ(tube_shape(pattern(geometry, 1, 0, flat), geometry)->alias, 5);
  const auto four = tube_shape(pattern(geometry, 4, 0.1, flat), geometry);
  EXPECT_EQ(four->order, 2);
  EXPECT_EQ(four->alias, 4);
}

TEST(TubeShape, DividesTheEnergyOfAMixture) {
  const TubeGeometry geometry = geometry_of({});
  ModeShape mixed = pattern(geometry, 2, 0.3, flat);
  const ModeShape bending = pattern(geometry, 1, 0.9, flat);
  for (std::size_t i = 0; i < mixed.places.size(); ++i) mixed.places[i].value += 0.5 * bending.places[i].value;
  const auto tube = tube_shape(mixed, geometry);
  EXPECT_EQ(tube->order, 2);
  EXPECT_NEAR(tube->energy[2], 0.8, kRounding);
  EXPECT_NEAR(tube->energy[1], 0.2, kRounding);
  EXPECT_LT(tube->confidence, tube_shape(pattern(geometry, 2, 0.3, flat), geometry)->confidence);
}

TEST(TubeShape, IsUncertainForAnEqualMixture) {
  const TubeGeometry geometry = geometry_of({});
  ModeShape mixed = pattern(geometry, 2, 0.3, flat);
  const ModeShape bending = pattern(geometry, 1, 0.9, flat);
  for (std::size_t i = 0; i < mixed.places.size(); ++i) mixed.places[i].value += bending.places[i].value;
  EXPECT_EQ(mode_type_of(*tube_shape(mixed, geometry)), ModeType::unknown);
}

TEST(TubeShape, GivesTheAxialFunction) {
  const TubeGeometry geometry = geometry_of({.rings = 9});
  const auto wave = [](double x) { return std::cos(pi * x / 0.16); };
  const auto tube = tube_shape(pattern(geometry, 2, 0.3, wave), geometry);
  ASSERT_EQ(tube->axial.size(), 9U);
  const double sign = tube->axial[0].value < 0 ? -1 : 1;
  for (const AxialValue& v : tube->axial) EXPECT_NEAR(sign * v.value, wave(v.position_m), kRounding) << v.position_m;
}

TEST(TubeShape, CountsSignChangesAlongTheAxis) {
  constexpr double kLength = 1.0;
  const TubeGeometry geometry = geometry_of({.rings = 21});
  for (int changes = 0; changes <= 4; ++changes) {
    const auto wave = [&](double x) { return std::cos(changes * pi * x / kLength); };
    for (const double noise : {0.0, 0.03})
      EXPECT_EQ(tube_shape(pattern(geometry, 1, 0.4, wave, noise), geometry)->sign_changes, changes) << noise;
  }
}

TEST(TubeShape, DoesNotCountTheSignsOfNoise) {
  const TubeGeometry geometry = geometry_of({.rings = 21});
  const auto barrel = [](double x) { return 1 / (1 + std::exp((x - 0.4) / 0.02)); };  // zero beyond 0.5 m
  EXPECT_EQ(tube_shape(pattern(geometry, 2, 0.4, barrel, 0.01), geometry)->sign_changes, 0);
}

TEST(TubeShape, HasNoSignChangesForOneRing) {
  const TubeGeometry geometry = geometry_of({.rings = 1, .angles = 8});
  const auto tube = tube_shape(pattern(geometry, 2, 0.3, flat), geometry);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->order, 2);
  EXPECT_FALSE(tube->sign_changes);
}

TEST(TubeShape, HasTrueStandardDeviations) {
  constexpr double kNoise = 0.05, kDeviations = 4;  // standard deviations of the plane
  const TubeGeometry geometry = geometry_of({.rings = 10});
  const auto tube = tube_shape(pattern(geometry, 2, 0.3, flat, kNoise), geometry);
  // 60 points determine the amplitudes of cos and sin: σ(nθ) = σ √(2/60).
  EXPECT_NEAR(tube->plane_std_rad, kNoise * std::sqrt(2.0 / 60) / 2, 0.1 * tube->plane_std_rad);
  EXPECT_LE(std::abs(*tube->plane_rad - 0.3), kDeviations * tube->plane_std_rad);
  EXPECT_NEAR(tube->axial[0].std, kNoise * std::sqrt(2.0 / 6), 1e-3 * kNoise);
}

TEST(TubeShape, IsUncertainForNoise) {
  const TubeGeometry geometry = geometry_of({});
  const auto nothing = [](double) { return 0.0; };
  EXPECT_LT(tube_shape(pattern(geometry, 1, 0, nothing, 1), geometry)->confidence, kClear);
}

TEST(TubeShape, NeedsFourDistinctAngles) {
  EXPECT_FALSE(tube_shape(pattern(geometry_of({.angles = 3}), 1, 0, flat), geometry_of({.angles = 3})));
  EXPECT_TRUE(tube_shape(pattern(geometry_of({.angles = 4}), 1, 0, flat), geometry_of({.angles = 4})));
  TubeGeometry line;
  for (std::size_t p = 0; p < 12; ++p) line[p] = {.position_m = 0.02 * static_cast<double>(p), .angle_rad = 0};
  EXPECT_FALSE(tube_shape(pattern(line, 1, 0, flat), line));
  EXPECT_FALSE(tube_shape({}, line));
}

TEST(TubeShape, AcceptsUnevenAngles) {
  TubeGeometry geometry = geometry_of({.rings = 4, .angles = 8});
  for (auto& [point, place] : geometry) place.angle_rad += 0.1 * std::sin(17.0 * static_cast<double>(point));
  const auto tube = tube_shape(pattern(geometry, 2, 0.3, flat), geometry);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->order, 2);
  ASSERT_TRUE(tube->plane_rad);
  EXPECT_NEAR(*tube->plane_rad, 0.3, kRounding);
}

// Points over a part of the circle: 0 to 180° in steps of 30°.
TubeGeometry half_circle() {
  TubeGeometry out;
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t a = 0; a < 7; ++a)
      out[r * 7 + a] = {.position_m = 0.05 * static_cast<double>(r), .angle_rad = static_cast<double>(a) * pi / 6};
  }
  return out;
}

TEST(TubeShape, HasSharesOfAtMostOneOverHalfACircle) {
  const TubeGeometry geometry = half_circle();
  for (int n = 0; n <= 5; ++n) {
    for (const double plane : {0.0, 0.4, 1.1}) {
      const auto tube = tube_shape(pattern(geometry, n, plane, flat, 1e-3), geometry);
      ASSERT_TRUE(tube);
      EXPECT_EQ(tube->order, n) << plane;
      for (const double share : tube->energy) EXPECT_LE(share, 1 + 1e-3);
      EXPECT_EQ(mode_type_of(*tube) == ModeType::bending, n == 1 && tube->confidence >= kMinTypeProbability) << n;
    }
  }
}

TEST(TubeShape, KeepsItsPlaneOverHalfACircle) {
  const TubeGeometry geometry = half_circle();
  const auto tube = tube_shape(pattern(geometry, 2, 0.4, flat), geometry);
  ASSERT_TRUE(tube && tube->plane_rad);
  EXPECT_NEAR(*tube->plane_rad, 0.4, kRounding);
}

}  // namespace percuss::identify::circumferential_orders_test
