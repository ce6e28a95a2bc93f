#pragma once
#include <string>

#include "acquire/formats/uff/uff_output.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record as a universal file: sets 151, 164, the geometry as 2411 where it is coordinates, its lines as 82,
/// and one function 58 (58b for UffData::binary) per hit and channel in N and m/s^2, the force first. Angles, positions
/// and the exact time step stand in the functions' fourth and fifth lines. Hits may differ in length.
/// errors  InputError: the file exists (without `force`) or cannot be written.
void write_uff(const std::string& path, const Record& record, bool force, UffData data = UffData::binary);

/// The lines whose two points have coordinates, so that their nodes are written.
std::vector<TraceLine> uff_drawable_lines(const std::vector<std::vector<double>>& geometry,
                                          const std::vector<TraceLine>& lines);

/// The lines of set 2411 for coordinates [points][3]; rows that are not finite are omitted.
std::string uff_node_lines(const std::vector<std::vector<double>>& geometry, int node_offset);

/// 1 where points begin below 1, because a node's number must not (node = point + 1); else 0.
int uff_node_offset(int lowest_point);

/// Directions of sensors around a tube along x whose angle counts from y: +2 for 0°, +3 for 90°, −2, −3; else +1.
int uff_direction(const SignalInfo& sensor);

/// The statements of percuss in the fifth and the fourth line of a function (see uff_annotation).
std::string uff_annotation_text(int node_offset, double dx);
std::string uff_sensor_text(const SignalInfo& sensor);

}  // namespace percuss::acquire
