#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// What a universal file says of how its nodes are connected.
struct UffTraceLines {
  std::vector<TraceLine> lines;    // by node, as they come; none twice
  std::size_t other_elements = 0;  // of kinds whose edges are not known here
  std::string unreadable;          // where a set could not be read to its end; empty: nowhere
};

/// The lines of the sets 82 (through nodes one after the other, 0 lifts the pen) and the edges of the elements of the
/// sets 2412: rods and beams, triangles and quadrilaterals, tetrahedra, wedges and bricks.
/// A set is read as far as it can be: drawings are no reason to refuse what was measured.
UffTraceLines read_uff_trace_lines(const std::vector<UffSet>& sets, const FileBytes& file);

/// The bodies of sets 82 that draw these lines (by point; node = point + offset): each as long as one line goes on
/// where the one before ended.
std::vector<std::string> uff_trace_line_sets(const std::vector<TraceLine>& lines, int offset);

}  // namespace percuss::acquire
