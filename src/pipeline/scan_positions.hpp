#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// Positions of a scan of impacts, one per point in the order of the points' numbers: evenly spaced, or listed.
struct ScanPositions {
  double start_m = 0, step_m = 0;
  std::size_t count = 0;
  std::vector<double> listed_m{};  // [count]; empty: evenly spaced
  /// The index of the position of each stated entry, if the list repeats a position for several hits; otherwise empty.
  std::vector<std::size_t> places{};
  double at_m(std::size_t i) const {
    return listed_m.empty() ? start_m + static_cast<double>(i) * step_m : listed_m[i];
  }
  std::size_t stated() const { return places.empty() ? count : places.size(); }
  std::size_t place(std::size_t entry) const { return places.empty() ? entry : places[entry]; }
};

/// The positions of a list, one per point in the order of the points' numbers. `where` names the input in messages.
/// errors  InputError with the option "positions": two positions are equal.
ScanPositions listed_positions(std::vector<double> position_m, const std::string& where);

/// As above, of a list that may repeat a position: these entries are hits of one position. The positions have the order
/// in which they occur first.
ScanPositions repeated_positions(const std::vector<double>& position_m);

/// The positions by the record's geometry: along the tube, or the coordinate in which the points differ.
/// errors  InputError with the option "positions": no geometry, a point without a place, points that lie on no line
/// parallel to an axis.
ScanPositions positions_of_geometry(const std::vector<std::vector<double>>& geometry, const std::set<int>& points,
                                    const std::string& where);

/// A record of one row that holds several hits, with a row for each hit, so that each can have its point; a note says
/// so. A row begins in the middle between the hit before it and its own, so that the ringing before the hit is known,
/// and ends with the samples of the hit. The options' time selection (from_s, to_s) is applied and must not be applied
/// again. Other records are returned unchanged; so are those with faults, and those of which a row alone would show
/// other hits.
acquire::Record with_row_per_hit(acquire::Record record, const acquire::HitOptions& options);

/// The record with one point per position. A record of one point needs as many rows as stated positions, or a multiple
/// of them. Its rows are assigned to the positions in order, and a note says so unless positions are repeated.
/// `points_are_files`: each point is a file. Files whose positions are equal become one point; other points may not
/// have equal positions.
/// errors  InputError: another number of points than stated positions; two points at one position.
acquire::Record as_scan(acquire::Record record, const ScanPositions& positions, bool points_are_files = false);

}  // namespace percuss::pipeline
