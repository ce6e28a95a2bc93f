#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "core/io/csv_dialect.hpp"

namespace percuss::acquire {

inline constexpr const char* kGeometryRemedy = "write a table like the example";

/// The columns of a geometry file.
enum GeometryField : std::size_t {
  kPoint,
  kX,
  kY,
  kZ,
  kPosition,
  kAngle,
  kRadius,
  kLines,
  kFaces,
  kDirection,
  kDx,
  kDy,
  kDz,
  kGeometryFields
};

struct GeometryColumn {
  std::optional<std::size_t> index;
  double to_SI = 1;
  bool unit = false;  // stated
};
using GeometryColumns = std::array<GeometryColumn, kGeometryFields>;

/// The name of a field in messages and columns: "x" for kX.
std::string_view geometry_field_name(std::size_t field);

/// Finds the columns by the names in the first line. `where` names the line.
/// errors  InputError: no column of points, no place, two kinds of places or directions, a column twice, an unknown
/// unit
GeometryColumns geometry_columns(const std::vector<std::string_view>& names, const std::string& where);

/// Takes a line of units below the names: a line without numbers. Returns false for a line with numbers.
bool take_units(GeometryColumns& columns, const std::vector<std::string_view>& cells, const CsvDialect& dialect,
                const std::string& where);

/// Whether lengths have no unit. They are then taken as m.
/// errors  InputError: an angle without a unit, lengths with and without one
bool lacks_length_unit(const GeometryColumns& columns, const std::string& where);

/// Refuses lengths without a unit that are too large for metres. `where` names the line of the names.
/// errors  InputError
void require_metres(const Geometry& geometry, const GeometryColumns& columns, const std::string& where);

}  // namespace percuss::acquire
