#include "acquire/geometry/geometry_connections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxCorners = 100;  // of a face
constexpr const char* kRowRemedy = "write line,0,1,2 or face,0,1,5,4 with the numbers of points";
constexpr const char* kCellRemedy = "write the numbers of the connected points, such as 4 5; for faces 4 5 1 / 1 5 6";

void add_numbers(std::string_view text, const std::string& where, const char* remedy, std::vector<int>& points) {
  constexpr std::string_view kBlanks = " \t";
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    int point = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), point);
    if (error != std::errc{} || rest != word.data() + word.size() || point < 0) {
      throw InputError(fmt::format("\"{}\" is not a point number", one_line(to_utf8(word), 40)), where, remedy);
    }
    points.push_back(point);
    at = text.find_first_not_of(kBlanks, end);
  }
}

void require_count(const Connection& connection, const char* remedy) {
  const std::size_t least = connection.face ? 3 : 2;
  if (connection.points.size() < least) {
    throw InputError(connection.face ? "a face with fewer than three corners" : "a line with fewer than two points",
                     connection.where, remedy);
  }
  if (connection.face && connection.points.size() > kMaxCorners)
    throw InputError("a face with more than 100 corners", connection.where, "divide it");
}

}  // namespace

bool is_connection_row(std::string_view first_cell) {
  const std::string word = lower_case(trimmed(first_cell));
  return word == "line" || word == "face";
}

Connection connection_of_row(const std::vector<std::string_view>& cells, const std::string& where) {
  Connection out{.face = lower_case(trimmed(cells.front())) == "face", .points = {}, .where = where};
  for (std::size_t i = 1; i < cells.size(); ++i) add_numbers(cells[i], where, kRowRemedy, out.points);
  require_count(out, kRowRemedy);
  return out;
}

std::vector<Connection> connections_of_cell(std::string_view cell, int point, bool face, const std::string& where) {
  std::vector<Connection> out;
  for (std::string_view rest = trimmed(cell); !rest.empty();) {
    const std::size_t end = face ? std::min(rest.find('/'), rest.size()) : rest.size();
    std::vector<int> others;
    add_numbers(rest.substr(0, end), where, kCellRemedy, others);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (face) {
      others.insert(others.begin(), point);
      out.push_back({.face = true, .points = std::move(others), .where = where});
      require_count(out.back(), kCellRemedy);
    } else {
      for (const int other : others) out.push_back({.face = false, .points = {point, other}, .where = where});
    }
  }
  return out;
}

void add_connections(Geometry& geometry, const std::vector<Connection>& connections) {
  std::set<int> known;
  for (const GeometryPoint& p : geometry.points) known.insert(p.point);
  std::set<std::array<int, 2>> lines;
  for (const Connection& connection : connections) {
    const auto& points = connection.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!known.contains(points[i])) {
        throw InputError(fmt::format("point {} is connected, but not listed", points[i]), connection.where,
                         "list the point with its coordinates");
      }
      const bool again = connection.face ? std::count(points.begin(), points.end(), points[i]) > 1
                                         : i > 0 && points[i] == points[i - 1];
      if (again)
        throw InputError(fmt::format("point {} is connected with itself", points[i]), connection.where, "name it once");
      if (connection.face || i == 0) continue;
      if (lines.insert({std::min(points[i - 1], points[i]), std::max(points[i - 1], points[i])}).second)
        geometry.lines.push_back({points[i - 1], points[i]});
    }
    if (connection.face) geometry.faces.push_back(points);
  }
}

void renumber_points(Geometry& geometry, const std::function<int(int)>& number) {
  for (GeometryPoint& point : geometry.points) point.point = number(point.point);
  for (auto& line : geometry.lines) {
    for (int& end : line) end = number(end);
  }
  for (auto& face : geometry.faces) {
    for (int& corner : face) corner = number(corner);
  }
}

void shift_points(Geometry& geometry, int by) {
  renumber_points(geometry, [by](int point) { return point + by; });
}

}  // namespace percuss::acquire
