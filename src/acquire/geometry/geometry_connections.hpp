#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/geometry/geometry.hpp"

namespace percuss::acquire {

/// Points of a geometry file that a line or a face connects.
struct Connection {
  bool face = false;
  std::vector<int> points;
  std::string where;  // file and line
};

/// Whether a line of a geometry file begins with the word "line" or "face".
bool is_connection_row(std::string_view first_cell);

/// Reads a row such as "line,0,1,2" or "face,0,1,5,4".
/// errors  InputError: a cell that is not a point number, fewer than two points (three for a face), or more than 100
/// corners of a face.
Connection connection_of_row(const std::vector<std::string_view>& cells, const std::string& where);

/// Reads the cell of a column `lines` ("4 5": points connected with this one) or `faces` ("4 5 1 / 1 5 6": the other
/// corners of each face).
/// errors  InputError: as connection_of_row.
std::vector<Connection> connections_of_cell(std::string_view cell, int point, bool face, const std::string& where);

/// Adds the lines and faces to a geometry whose points are complete.
/// errors  InputError: a point that the geometry lacks, or that is named twice in one face or twice in succession in a
/// line.
void add_connections(Geometry& geometry, const std::vector<Connection>& connections);

}  // namespace percuss::acquire
