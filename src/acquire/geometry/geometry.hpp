#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::acquire {

/// A point of a survey: its number in the records, and where it lies. Either coordinates, or a place on a tube.
struct GeometryPoint {
  int point = 0;
  std::optional<std::array<double, 3>> xyz_m;
  double position_m = 0;  // along the tube's axis, from the barrel's end
  double angle_rad = 0;   // around it
  double radius_m = 0;    // for drawings; 0: not stated
};

struct Geometry {
  std::vector<GeometryPoint> points;  // as in the file
  bool tube = false;                  // position and angle are known for every point
};

/// Reads where the points of a survey lie from a text of one line per point (docs/reference/formats.md, "Geometry"):
///   point, x_m, y_m, z_m                      or
///   point, position_m, angle_deg[, radius_m]
/// Names of columns in any order; units m, mm, cm, in and deg, rad as in "x_mm" or "angle (rad)", or in a line of
/// units; delimiters, quotes and comments as in records. Coordinates of points around an axis are turned into position
/// and angle (tube_from_coordinates). errors  InputError with file, line and remedy: no such columns, a cell that is no
/// number, a point twice, no unit, too long.
Geometry read_geometry(const std::string& path);

/// As read_geometry, for a text in memory; `where` names it.
Geometry parse_geometry(std::string_view text, const std::string& where);

/// The geometry that a record carries: [points][3] coordinates in m, or [points][2] position in m and angle in degrees;
/// row i is point i. Nothing for an empty one.
std::optional<Geometry> geometry_of_record(const std::vector<std::vector<double>>& rows);

/// Fills position, angle and radius of points that have coordinates, when these lie in rings around one of the axes x,
/// y or z (through the middle of the points): position is the coordinate along the axis, the angle counts from the next
/// axis (y for x, z for y, x for z) towards the one after. Otherwise leaves them and `tube` alone.
void tube_from_coordinates(Geometry& geometry);

/// A grid of a barrel, as a user may start from.
std::string geometry_example();

}  // namespace percuss::acquire
