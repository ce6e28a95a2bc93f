#include "acquire/geometry/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "acquire/geometry/geometry_columns.hpp"
#include "acquire/geometry/geometry_connections.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMaxGeometry_bytes = std::uint64_t{16} << 20U;
constexpr std::size_t kMaxGeometryPoints = 100'000;
constexpr double kMaxCoordinate_m = 1e4;  // m or rad: larger than any structure

// A line of the file that is neither blank nor a comment.
struct Line {
  std::size_t number = 0;  // from 1
  std::string_view text;
};

std::vector<Line> lines_of(std::string_view text, char line_end) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text, line_end);
    const CsvDialect any;
    if (!is_skipped(line, any)) lines.push_back({number, line});
  }
  return lines;
}

std::string place(const std::string& where, std::size_t line) { return fmt::format("{}: line {}", where, line); }

std::string shown(std::string_view cell) { return one_line(to_utf8(trimmed(cell)), 40); }

class Row {
 public:
  Row(std::vector<std::string_view> cells, bool decimal_comma, std::string where)
      : cells_(std::move(cells)), decimal_comma_(decimal_comma), where_(std::move(where)) {}

  double number(const GeometryColumns& columns, std::size_t field) const {
    const std::size_t index = *columns[field].index;
    const auto title = geometry_field_name(field);
    if (index >= cells_.size()) throw InputError(fmt::format("no cell for {}", title), where_, "fill every column");
    const ParsedNumber parsed = parse_number(cells_[index], decimal_comma_);
    if (parsed.problem != NumberProblem::none) {
      throw InputError(fmt::format("{} \"{}\" is {}", title, shown(cells_[index]), describe(parsed.problem)), where_,
                       "write a number");
    }
    const double value = parsed.value * columns[field].to_SI;
    if (std::abs(value) <= kMaxCoordinate_m || field == kPoint) return value;
    throw InputError(fmt::format("{} {:g} is too large", title, parsed.value), where_, "check its unit");
  }

  // Adds the connections in the point's cells of the columns `lines` and `faces`.
  void add_connections(const GeometryColumns& columns, std::vector<Connection>& out) const {
    for (const GeometryField field : {kLines, kFaces}) {
      const auto index = columns[field].index;
      if (!index || *index >= cells_.size()) continue;
      for (Connection& each : connections_of_cell(cells_[*index], point(columns), field == kFaces, where_))
        out.push_back(std::move(each));
    }
  }

  // The direction of a blow or sensor; nothing where its cells are empty.
  std::optional<std::array<double, 3>> direction(const GeometryColumns& columns) const {
    const std::string_view name = cell(columns, kDirection);
    if (!name.empty()) return axis_of(name);
    std::array<double, 3> out{};
    bool stated = false;
    for (std::size_t axis = 0; axis < out.size(); ++axis) {
      const std::size_t field = kDx + axis;
      if (cell(columns, field).empty()) continue;
      out.at(axis) = number(columns, field);
      stated = true;
    }
    if (!stated) return std::nullopt;
    const double length = std::hypot(out[0], out[1], out[2]);
    if (!(length > 0)) {
      throw InputError("the direction dx, dy, dz has no length", where_,
                       "give the direction of the blow or sensor, such as 0,0,-1, or leave the cells empty");
    }
    for (double& component : out) component = component / length + 0.0;  // no −0
    return out;
  }

  int point(const GeometryColumns& columns) const {
    const double value = number(columns, kPoint);
    if (std::abs(value) <= static_cast<double>(kMaxPointNumber) && std::rint(value) == value &&
        is_point_number(static_cast<std::int64_t>(value)))
      return static_cast<int>(value);
    throw InputError(fmt::format("{:g} is not a point number", value), where_,
                     "number points as the records do, from 0");
  }

 private:
  // Without blanks; empty where the file has no such column, or the row no such cell.
  std::string_view cell(const GeometryColumns& columns, std::size_t field) const {
    const auto index = columns.at(field).index;
    return index && *index < cells_.size() ? trimmed(cells_[*index]) : std::string_view();
  }

  // "+x", "-z", "y", or "z-" as some programs write it.
  std::array<double, 3> axis_of(std::string_view name) const {
    const auto is_sign = [](char c) { return c == '+' || c == '-'; };
    const char sign = is_sign(name.front()) ? name.front() : is_sign(name.back()) ? name.back() : '+';
    std::string_view letters = name;
    if (is_sign(letters.front())) {
      letters.remove_prefix(1);
    } else if (is_sign(letters.back())) {
      letters.remove_suffix(1);
    }
    const std::string axis = lower_case(to_utf8(letters));
    if (axis != "x" && axis != "y" && axis != "z") {
      throw InputError(fmt::format("unknown direction \"{}\"", shown(name)), where_,
                       "write +x, -x, +y, -y, +z or -z, or give the columns dx, dy and dz");
    }
    std::array<double, 3> out{};
    out.at(static_cast<std::size_t>(axis.front() - 'x')) = sign == '-' ? -1 : 1;
    return out;
  }

  std::vector<std::string_view> cells_;
  bool decimal_comma_;
  std::string where_;
};

GeometryPoint point_of(const Row& row, const GeometryColumns& columns) {
  GeometryPoint out{.point = row.point(columns)};
  const auto number = [&](std::size_t field) { return columns[field].index ? row.number(columns, field) : 0; };
  if (columns[kAngle].index) {
    out.position_m = number(kPosition);
    out.angle_rad = number(kAngle);
  } else if (columns[kPosition].index) {
    out.xyz_m = {number(kPosition), 0, 0};
  } else {
    out.xyz_m = {number(kX), number(kY), number(kZ)};
  }
  if (columns[kRadius].index) out.radius_m = row.number(columns, kRadius);
  out.along = row.direction(columns);
  return out;
}

CsvDialect dialect_of(const std::vector<Line>& lines, char line_end) {
  std::vector<std::string_view> probes;
  for (const Line& line : lines) {
    const std::string_view word = line.text.substr(0, line.text.find_first_of(",;\t "));
    if (probes.size() < 64 && (probes.empty() || !is_connection_row(word))) probes.push_back(line.text);
  }
  std::rotate(probes.begin(), probes.begin() + 1, probes.end());  // numbers first, names last
  return find_dialect(probes, line_end);
}

}  // namespace

Geometry parse_geometry(std::string_view text, const std::string& where) {
  if (text.size() > kMaxGeometry_bytes) throw InputError("longer than 16 MiB", where, "keep one line per point");
  text = without_byte_order_mark(text);
  if (text.find('\0') != std::string_view::npos)
    throw InputError("not a text file", where, kGeometryRemedy, {"survey.example"});
  const char line_end = find_line_end(text);
  const std::vector<Line> lines = lines_of(text, line_end);
  if (lines.size() < 2) throw InputError("no points", where, kGeometryRemedy, {"survey.example"});
  const CsvDialect dialect = dialect_of(lines, line_end);
  GeometryColumns columns =
      geometry_columns(split_cells(lines.front().text, dialect), place(where, lines.front().number));
  Geometry geometry;
  std::set<int> seen;
  std::vector<Connection> connections;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string at = place(where, lines[i].number);
    auto cells = split_cells(lines[i].text, dialect);
    if (i == 1 && take_units(columns, cells, dialect, at)) continue;
    if (geometry.points.empty()) geometry.unit_assumed = lacks_length_unit(columns, place(where, lines.front().number));
    if (!cells.empty() && is_connection_row(cells.front())) {
      connections.push_back(connection_of_row(cells, at));
      continue;
    }
    const Row row(std::move(cells), dialect.decimal_comma, at);
    geometry.points.push_back(point_of(row, columns));
    row.add_connections(columns, connections);
    if (geometry.points.size() > kMaxGeometryPoints)
      throw InputError("more than 100000 points", at, "keep only the points that were hit");
    if (!seen.insert(geometry.points.back().point).second)
      throw InputError(fmt::format("point {} is listed twice", geometry.points.back().point), at, "keep one");
  }
  if (geometry.points.empty()) throw InputError("no points", where, kGeometryRemedy, {"survey.example"});
  add_connections(geometry, connections);
  if (geometry.unit_assumed) require_metres(geometry, columns, place(where, lines.front().number));
  geometry.tube = columns[kAngle].index.has_value();
  const bool spatial = columns[kX].index && columns[kY].index && columns[kZ].index;
  if (spatial) tube_from_coordinates(geometry);
  return geometry;
}

Geometry read_geometry(const std::string& path) {
  return parse_geometry(read_input(path, kMaxGeometry_bytes).view(), input_name(path));
}

std::string geometry_example() {
  std::string text =
      "# where each point lies: along the barrel from its end, and around it; point as in the records\n"
      "point,position_m,angle_deg,radius_m\n";
  int point = 0;
  for (const double position_m : {0.038, 0.102, 0.165}) {
    for (int angle = 0; angle < 360; angle += 45)
      text += fmt::format("{},{:.3f},{},0.0333\n", point++, position_m, angle);
  }
  return text;
}

const GeometryPoint* find_point(const Geometry& geometry, int point) {
  const auto at = std::find_if(geometry.points.begin(), geometry.points.end(),
                               [&](const GeometryPoint& one) { return one.point == point; });
  return at == geometry.points.end() ? nullptr : &*at;
}

}  // namespace percuss::acquire
