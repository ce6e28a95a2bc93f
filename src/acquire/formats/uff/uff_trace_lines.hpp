#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The connections between nodes of a universal file.
struct UffTraceLines {
  std::vector<TraceLine> lines;    // by node, in the file's order, without duplicates
  std::vector<TraceFace> faces;    // by node: plane elements and shells of the sets 2412
  std::size_t other_elements = 0;  // of kinds whose edges are not known
  std::string unreadable;          // the first error message of an unreadable set; empty: none
};

/// The lines of the sets 82 and the edges of the elements of the sets 2412: rods and beams, triangles and
/// quadrilaterals, tetrahedra, wedges and bricks. A set 82 connects its nodes in order; a 0 interrupts the line. A set
/// is read as far as possible, without an error: a measurement is usable without its trace lines.
UffTraceLines read_uff_trace_lines(const std::vector<UffSet>& sets, const FileBytes& file);

/// The bodies of sets 82 that draw these lines (by point; node = point + offset). A set continues while each line
/// starts at the end of the previous one.
std::vector<std::string> uff_trace_line_sets(const std::vector<TraceLine>& lines, int offset);

/// Whether a set 2412 of percuss holds the face: a triangle or a quadrilateral.
bool is_uff_element(const TraceFace& face);

/// The body of a set 2412 of these faces (by point; node = point + offset): triangles and quadrilaterals as thin
/// shells. Other faces are left out.
std::string uff_element_lines(const std::vector<TraceFace>& faces, int offset);

}  // namespace percuss::acquire
