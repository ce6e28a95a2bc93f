#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::acquire {

/// A point of a survey: its number in the records and its place, as coordinates or on a tube.
struct GeometryPoint {
  int point = 0;
  std::optional<std::array<double, 3>> xyz_m;
  double position_m = 0;                         // along the tube's axis, from the barrel's end
  double angle_rad = 0;                          // around the axis
  double radius_m = 0;                           // for drawings; 0: not stated
  std::optional<std::array<double, 3>> along{};  // unit vector of a positive value: of the blow or of the sensor
};

struct Geometry {
  std::vector<GeometryPoint> points;        // as in the file
  bool tube = false;                        // position and angle are known for every point
  std::size_t axis = 0;                     // of the tube: 0, 1, 2 for x, y, z; x without coordinates
  std::vector<std::array<int, 2>> lines{};  // by point number, each once; empty: none stated
  std::vector<std::vector<int>> faces{};    // corners in order around each face, by point number
  bool unit_assumed = false;                // the file states no unit: its lengths are taken as m
};

/// Reads the places of a survey's points from a text with one line per point (docs/reference/formats.md, "Geometry of a
/// survey"):
///   point, x_m, y_m, z_m                      or
///   point, position_m, angle_deg[, radius_m]
/// A coordinate without a column is 0; positions without angles lie on a line. Drawings connect points by the optional
/// columns `lines` and `faces`, or by rows "line,0,1,2" and "face,0,1,5,4" (see geometry_connections.hpp). Columns may
/// have any order. Units are m, mm, cm, in and deg, rad; they stand in the name ("x_mm", "angle (rad)") or in a line of
/// units. Lengths without a unit are taken as m unless they exceed 10. Optional columns state the direction of a blow
/// or sensor: `dx`, `dy` and `dz` of any length, or `direction` with +x … -z; points without one have empty cells.
/// Delimiters, quotes and comments are as in records. Coordinates of points around an axis are turned into position and
/// angle (tube_from_coordinates).
/// errors  InputError with file, line and remedy: no such columns, a cell that is not a number, a point twice, lengths
///         above 10 or an angle without a unit, a connection with a point that is not listed, an unknown direction or
///         one without length, a text that is too long.
Geometry read_geometry(const std::string& path);

/// As read_geometry, for a text in memory; `where` names it.
Geometry parse_geometry(std::string_view text, const std::string& where);

/// The geometry that a record carries: [points][3] coordinates in m, or [points][2] position in m and angle in degrees;
/// row i is point i. Nothing for an empty one.
std::optional<Geometry> geometry_of_record(const std::vector<std::vector<double>>& rows);

/// The point of this number; nullptr without one.
const GeometryPoint* find_point(const Geometry& geometry, int point);

/// Fills position, angle and radius of points whose coordinates lie in rings around an axis parallel to x, y or z
/// through their mean. The position is the coordinate along the axis. The angle counts from the next axis (y for x, z
/// for y, x for z) towards the one after. Changes nothing if they do not lie in rings.
void tube_from_coordinates(Geometry& geometry);

/// Replaces all point numbers, also in the lines and faces. number(n) is the new number of point n; different points
/// need different numbers.
void renumber_points(Geometry& geometry, const std::function<int(int)>& number);

/// Adds `by` to all point numbers, also in the lines and faces.
void shift_points(Geometry& geometry, int by);

/// An example: a grid on a barrel.
std::string geometry_example();

}  // namespace percuss::acquire
