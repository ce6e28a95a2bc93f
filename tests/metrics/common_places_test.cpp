#include "metrics/common_places.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace percuss::metrics::common_places_test {

using Coordinates = std::array<double, 3>;

// A document with one mode, whose values are given by point.
ComparedDocument document_of(const std::map<int, double>& shape, const std::map<int, ComparedPlace>& places = {}) {
  ComparedMode mode{.freq_Hz = 100, .shape = {}};
  for (const auto& [point, value] : shape) mode.shape[{point, -1}] = {.value = value, .std = 0};
  return {.name = "", .schema = "", .modes = {mode}, .deflections = {}, .places = places};
}

ComparedPlace at(int number, std::optional<Coordinates> xyz_m, std::optional<Coordinates> direction = {}) {
  return {.number = number, .xyz_m = xyz_m, .direction = direction};
}

double mac_of(const ComparedDocument& a, const ComparedDocument& b) {
  const auto mac = mac_between(a.modes.at(0), at_places_of_first(b, common_places(a, b)).modes.at(0));
  EXPECT_TRUE(mac.has_value());
  return mac ? mac->value : -1;
}

constexpr double kRounding = 1e-12;  // the shapes are exact

// Points 0 to 4 along a line, spaced by 0.1 m.
std::map<int, ComparedPlace> along_a_line(double origin_m = 0, double scale = 1) {
  std::map<int, ComparedPlace> places;
  for (int p = 0; p < 5; ++p) places[p] = at(p + 1, Coordinates{scale * (origin_m + 0.1 * p), 0, 0});
  return places;
}

TEST(CommonPlaces, MatchesByCoordinates) {
  const auto a = document_of({{0, 1}, {1, 2}, {2, -1}, {3, 0.5}, {4, 3}}, along_a_line());
  // Without the second point, in another order, and 0.4 mm off.
  const auto b = document_of({{0, 3}, {1, 0.5}, {2, -1}, {3, 1}}, {{0, at(7, Coordinates{0.4004, 0, 0})},
                                                                   {1, at(2, Coordinates{0.3, 0.0004, 0})},
                                                                   {2, at(1, Coordinates{0.2, 0, 0})},
                                                                   {3, at(9, Coordinates{0, 0, 0})}});
  const CommonPlaces common = common_places(a, b);
  EXPECT_EQ(common.by, PlacesMatchedBy::coordinates);
  EXPECT_EQ(common.of_b.size(), 4U);
  EXPECT_EQ(common.points_a, 5U);
  EXPECT_EQ(common.points_b, 4U);
  EXPECT_FALSE(common.coordinates_differ);
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
  EXPECT_NEAR(mac_of(b, a), 1, kRounding);
}

// A model has many more nodes than a test has points: the nearest one pairs, if it is within the tolerance.
TEST(CommonPlaces, TakesTheNearestNodeOfAMesh) {
  std::map<int, ComparedPlace> nodes;
  std::map<int, double> values;
  for (int n = 0; n < 81; ++n) {
    nodes[100 + n] = at(100 + n, Coordinates{0.005 * n + 0.001, 0, 0});
    values[100 + n] = n;
  }
  const auto test = document_of({{0, 0}, {1, 20}, {2, 40}, {3, 60}, {4, 80}}, along_a_line());
  const auto model = document_of(values, nodes);
  const CommonPlaces common = common_places(test, model);
  EXPECT_EQ(common.by, PlacesMatchedBy::coordinates);
  EXPECT_EQ(common.of_b.size(), 5U);
  EXPECT_NEAR(mac_of(test, model), 1, kRounding);
}

TEST(CommonPlaces, TurnsOppositeDirections) {
  const Coordinates up{0, 0, 1}, down{0, 0, -1}, across{0, 1, 0};
  const auto line = [](const std::vector<Coordinates>& directions) {
    std::map<int, ComparedPlace> places = along_a_line();
    for (int p = 0; p < 5; ++p) places[p].direction = directions.at(static_cast<std::size_t>(p));
    return places;
  };
  const auto a = document_of({{0, 1}, {1, 2}, {2, -1}, {3, 0.5}, {4, 3}}, line({up, up, up, up, up}));
  const auto b = document_of({{0, 1}, {1, -2}, {2, -1}, {3, -0.5}, {4, 7}}, line({up, down, up, down, across}));
  EXPECT_EQ(common_places(a, b).of_b.size(), 4U) << "the last point moves across";
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
}

TEST(CommonPlaces, UsesNumbersWithoutCoordinates) {
  const auto a =
      document_of({{0, 1}, {1, 2}, {2, -1}, {3, 3}}, {{0, at(1, {})}, {1, at(2, {})}, {2, at(3, {})}, {3, at(4, {})}});
  // Without P2.
  const auto b = document_of({{0, 1}, {1, -1}, {2, 3}}, {{0, at(1, {})}, {1, at(3, {})}, {2, at(4, {})}});
  EXPECT_EQ(common_places(a, b).by, PlacesMatchedBy::numbers);
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
  // A document without places has its record's numbers.
  const auto plain = document_of({{1, 1}, {3, -1}, {4, 3}});
  EXPECT_EQ(common_places(a, plain).by, PlacesMatchedBy::numbers);
  EXPECT_NEAR(mac_of(a, plain), 1, kRounding);
}

TEST(CommonPlaces, UsesTheSequenceIfOneCountsFromZero) {
  const auto a = document_of({{0, 1}, {1, 2}, {2, -1}, {3, 3}}), b = document_of({{1, 1}, {2, 2}, {3, -1}, {4, 3}});
  EXPECT_EQ(common_places(a, b).by, PlacesMatchedBy::sequence);
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
  EXPECT_NEAR(mac_of(b, a), 1, kRounding);
  const auto more = document_of({{1, 1}, {2, 2}, {3, -1}, {4, 3}, {5, 1}});
  EXPECT_EQ(common_places(a, more).by, PlacesMatchedBy::numbers) << "not as many points";
}

TEST(CommonPlaces, SaysThatCoordinatesDiffer) {
  const std::map<int, double> shape{{0, 1}, {1, 2}, {2, -1}, {3, 0.5}, {4, 3}};
  const auto metres = document_of(shape, along_a_line(0.05)),
             millimetres = document_of(shape, along_a_line(0.05, 1000));
  const CommonPlaces common = common_places(metres, millimetres);
  EXPECT_EQ(common.by, PlacesMatchedBy::numbers);
  EXPECT_TRUE(common.coordinates_differ);
  EXPECT_EQ(common.of_b.size(), 5U);
}

// The origin of a model's grid is at its centre, so that half of its points lie at other points of the test.
TEST(CommonPlaces, BelievesNumbersOfMorePoints) {
  std::map<int, ComparedPlace> test, model;
  std::map<int, double> shape;
  for (int p = 0; p < 9; ++p) {
    test[p] = at(p + 1, Coordinates{0.1 * p, 0, 0});
    model[p] = at(p + 1, Coordinates{0.1 * (p - 4), 0, 0});
    shape[p] = p * p - 10;
  }
  const auto a = document_of(shape, test), b = document_of(shape, model);
  const CommonPlaces common = common_places(a, b);
  EXPECT_EQ(common.by, PlacesMatchedBy::numbers);
  EXPECT_EQ(common.of_b.size(), 9U);
  EXPECT_TRUE(common.coordinates_differ);
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
}

TEST(CommonPlaces, TurnsOppositeDirectionsOfEqualNumbers) {
  const Coordinates up{0, 0, 1}, down{0, 0, -1};
  const auto a = document_of({{1, 1}, {2, 2}, {3, -1}}, {{1, at(1, {}, up)}, {2, at(2, {}, up)}, {3, at(3, {}, up)}});
  const auto b =
      document_of({{1, 1}, {2, -2}, {3, -1}}, {{1, at(1, {}, up)}, {2, at(2, {}, down)}, {3, at(3, {}, up)}});
  EXPECT_NEAR(mac_of(a, b), 1, kRounding);
}

// Foreign documents may state directions of any length.
TEST(CommonPlaces, ComparesDirectionsOfAnyLength) {
  const Coordinates up{0, 0, 0.5}, down{0, 0, -3};
  std::map<int, ComparedPlace> a = along_a_line(), b = along_a_line();
  for (int p = 0; p < 5; ++p) {
    a[p].direction = up;
    b[p].direction = down;
  }
  const CommonPlaces common = common_places(document_of({{0, 1}, {1, 2}, {2, -1}, {3, 0.5}, {4, 3}}, a),
                                            document_of({{0, 1}, {1, 2}, {2, -1}, {3, 0.5}, {4, 3}}, b));
  EXPECT_EQ(common.by, PlacesMatchedBy::coordinates);
  ASSERT_EQ(common.of_b.size(), 5U);
  EXPECT_EQ(common.of_b.at(0).sign, -1);
}

// Coordinates of 0 for every point say nothing.
TEST(CommonPlaces, DoesNotBelieveOnePlaceOfAllPoints) {
  std::map<int, ComparedPlace> places;
  for (int p = 0; p < 4; ++p) places[p] = at(p, Coordinates{0, 0, 0});
  const auto a = document_of({{0, 1}, {1, 2}, {2, -1}, {3, 3}}, places);
  EXPECT_EQ(common_places(a, a).by, PlacesMatchedBy::numbers);
}

// A comparison of all pairs of so many points would take minutes, and much memory if they lie at two places.
TEST(CommonPlaces, ComparesNoCoordinatesOfTooManyPoints) {
  std::map<int, ComparedPlace> places;
  std::map<int, double> shape;
  for (int p = 0; p < 20000; ++p) {
    places[p] = at(p, Coordinates{p % 2 == 0 ? 0.0 : 1.0, 0, 0});
    shape[p] = p;
  }
  const auto a = document_of(shape, places);
  const CommonPlaces common = common_places(a, a);
  EXPECT_EQ(common.by, PlacesMatchedBy::numbers);
  EXPECT_EQ(common.of_b.size(), 20000U);
}

TEST(CommonPlaces, HasNoneWithoutShapes) {
  const CommonPlaces common = common_places(document_of({}), document_of({{0, 1}}));
  EXPECT_TRUE(common.of_b.empty());
  EXPECT_EQ(common.points_a, 0U);
}

}  // namespace percuss::metrics::common_places_test
