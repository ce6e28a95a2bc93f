#pragma once
#include <cstddef>
#include <map>

#include "metrics/compare.hpp"

namespace percuss::metrics {

/// How the points of two documents were matched.
enum class PlacesMatchedBy {
  coordinates,  // both documents state the coordinates of all points of their shapes
  numbers,      // by the displayed numbers: of the stated geometry or of the file names, otherwise of the record
  sequence      // both have equally many points, numbered without gaps, one from 0 and the other from 1
};
/// "coordinates", "numbers" or "sequence".
const char* name_of(PlacesMatchedBy by);

/// A point of the first document at the place of a point of the second.
struct MatchedPoint {
  int point = 0;
  double sign = 1;  // -1: the positive directions of the two points are opposite
};

struct CommonPlaces {
  PlacesMatchedBy by = PlacesMatchedBy::numbers;
  std::map<int, MatchedPoint> of_b{};      // by the point of the second document
  std::size_t points_a = 0, points_b = 0;  // with values in a shape
  bool coordinates_differ = false;         // both state coordinates, but these pair too few points to be used
};

/// Matches the points of the shapes of two documents.
/// By coordinates, the nearest points pair first. Two points that pair are no further apart than 1 % of the largest
/// extent of the document with fewer points, and than a quarter of the smallest distance between two of its places.
/// Points whose stated directions are not parallel do not pair. Numbers decide if coordinates give fewer than
/// kMinPlaces pairs, or fewer pairs than the numbers do: the two documents may have different origins. They also decide
/// for more than ten million pairs of points, whose coordinates are not compared.
CommonPlaces common_places(const ComparedDocument& a, const ComparedDocument& b);

/// The second document with the point numbers and directions of the first, without the values at other places.
ComparedDocument at_places_of_first(ComparedDocument b, const CommonPlaces& common);

}  // namespace percuss::metrics
