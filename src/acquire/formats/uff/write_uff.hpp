#pragma once
#include <string>

#include "acquire/formats/uff/uff_output.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record as a universal file: sets 151 and 164; a geometry of coordinates as 2411, its trace lines as 82 and
/// its faces as 2412; one function 58 (58b for UffData::binary) per hit and channel in N and m/s^2 (or Pa), the force
/// first.
/// The fourth line of a function states angle and position, the fifth the exact time step. Hits may differ in length.
/// errors  InputError: the file exists (without `force`) or cannot be written.
void write_uff(const std::string& path, const Record& record, bool force, UffData data = UffData::binary);

/// The lines whose two points have coordinates. Only such points are written as nodes.
std::vector<TraceLine> uff_drawable_lines(const std::vector<std::vector<double>>& geometry,
                                          const std::vector<TraceLine>& lines);

/// The triangles and quadrilaterals whose corners all have coordinates. Other faces are not written.
std::vector<TraceFace> uff_drawable_faces(const std::vector<std::vector<double>>& geometry,
                                          const std::vector<TraceFace>& faces);

/// The lines of set 2411 for coordinates [points][3]; rows that are not finite are omitted.
std::string uff_node_lines(const std::vector<std::vector<double>>& geometry, int node_offset);

/// Offset of node numbers, node = point + offset: 1 if the lowest point is below 1, else 0. Node numbers start at 1.
int uff_node_offset(int lowest_point);

/// Direction code of a sensor on a tube along x, with angles counted from y: +2 (y) for 0°, +3 (z) for 90°, −2 for
/// 180°, −3 for 270°; +1 (x) for other or unknown angles.
int uff_direction(const SignalInfo& sensor);

/// The statements of percuss in the fifth line of a function (see uff_annotation).
std::string uff_annotation_text(int node_offset, double dx);
/// The statements of percuss about a sensor in the fourth line of a function.
std::string uff_sensor_text(const SignalInfo& sensor);

}  // namespace percuss::acquire
