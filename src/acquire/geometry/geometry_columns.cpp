#include "acquire/geometry/geometry_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr double kMaxAssumed_m = 10;         // of lengths without a unit; larger ones are probably in mm or inches
constexpr std::size_t kEndOfUnits = kLines;  // the fields from kX to before kLines have units

constexpr std::array<std::array<std::string_view, 3>, kGeometryFields> kNames = {{{"point", "node", "no"},
                                                                                  {"x"},
                                                                                  {"y"},
                                                                                  {"z"},
                                                                                  {"position", "pos", "axial"},
                                                                                  {"angle", "theta", "phi"},
                                                                                  {"radius", "r"},
                                                                                  {"lines"},
                                                                                  {"faces"},
                                                                                  {"direction"},
                                                                                  {"dx"},
                                                                                  {"dy"},
                                                                                  {"dz"}}};
Quantity quantity_of(std::size_t field) { return field == kAngle ? Quantity::angle : Quantity::length; }

void set_unit(GeometryColumn& column, std::size_t field, std::string_view unit, const std::string& where) {
  column.to_SI = require_unit(unit, quantity_of(field), where).to_SI;
  column.unit = true;
}

std::string title_in(std::size_t field, std::string_view unit) {
  return fmt::format("{}_{}", kNames.at(field).front(), unit);
}

}  // namespace

std::string_view geometry_field_name(std::size_t field) { return kNames.at(field).front(); }

GeometryColumns geometry_columns(const std::vector<std::string_view>& names, const std::string& where) {
  GeometryColumns columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NameAndUnit name = split_name(to_utf8(names[i]));
    for (std::size_t field = 0; field < kGeometryFields; ++field) {
      const auto& known = kNames[field];
      const std::string base = lower_case(name.base);
      if (base.empty() || std::find(known.begin(), known.end(), base) == known.end()) continue;
      if (columns[field].index)
        throw InputError(fmt::format("two columns are called {}", kNames[field].front()), where, "keep one");
      columns[field].index = i;
      if (field != kPoint && field < kEndOfUnits && !name.unit.empty())
        set_unit(columns[field], field, name.unit, where);
    }
  }
  const auto has = [&](GeometryField field) { return columns[field].index.has_value(); };
  if (!has(kPoint)) throw InputError("no column of points", where, kGeometryRemedy, {"survey.example"});
  const bool cartesian = has(kX) || has(kY) || has(kZ), tube = has(kPosition) || has(kAngle);
  if (cartesian == tube || (tube && !has(kPosition))) {
    throw InputError("the columns hold no coordinates, or two kinds of them", where,
                     "give x, y, z (missing ones are 0), or position with or without angle: point,x_m,y_m,z_m or "
                     "point,position_m,angle_deg");
  }
  if (has(kDirection) && (has(kDx) || has(kDy) || has(kDz)))
    throw InputError("the columns hold two kinds of directions", where, "keep direction, or dx, dy and dz");
  return columns;
}

bool take_units(GeometryColumns& columns, const std::vector<std::string_view>& cells, const CsvDialect& dialect,
                const std::string& where) {
  for (const std::string_view cell : cells) {
    if (parse_number(cell, dialect.decimal_comma).problem != NumberProblem::not_a_number && !trimmed(cell).empty())
      return false;
  }
  for (std::size_t field = kX; field < kEndOfUnits; ++field) {
    GeometryColumn& column = columns[field];
    if (column.index && *column.index < cells.size() && !trimmed(cells[*column.index]).empty())
      set_unit(column, field, to_utf8(trimmed(cells[*column.index])), where);
  }
  return true;
}

bool lacks_length_unit(const GeometryColumns& columns, const std::string& where) {
  std::optional<std::size_t> without, with;
  for (std::size_t field = kX; field < kEndOfUnits; ++field) {
    if (!columns.at(field).index) continue;
    const bool angle = quantity_of(field) == Quantity::angle;
    if (columns.at(field).unit) {
      if (!angle) with = field;
      continue;
    }
    if (angle) throw InputError("no unit for angle", where, "call the column angle_deg or angle_rad");
    without = field;
  }
  if (!without || !with) return without.has_value();
  throw InputError(fmt::format("no unit for {}", geometry_field_name(*without)), where,
                   fmt::format("call the column {}, for instance", title_in(*without, "m")));
}

void require_metres(const Geometry& geometry, const GeometryColumns& columns, const std::string& where) {
  double largest = 0;
  for (const GeometryPoint& point : geometry.points) {
    for (const double x : point.xyz_m.value_or(std::array<double, 3>{point.position_m, point.radius_m, 0}))
      largest = std::max(largest, std::abs(x));
  }
  if (largest <= kMaxAssumed_m) return;
  const std::size_t field = columns[kPosition].index ? kPosition : columns[kX].index ? kX : columns[kY].index ? kY : kZ;
  throw InputError(fmt::format("no unit for lengths of up to {:g}", largest), where,
                   fmt::format("call the column {} if they are in mm, {} in m, {} in inches; the others likewise",
                               title_in(field, "mm"), title_in(field, "m"), title_in(field, "in")));
}

}  // namespace percuss::acquire
