#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/error.hpp"

namespace percuss::acquire {

/// A unit vector in the coordinates of the geometry.
using Direction = std::array<double, 3>;

/// What a file states about a degree of freedom. With a roving hammer it is a struck point. With roving sensors it is
/// the place of one sensor.
struct PointMotion {
  int point = 0;
  std::size_t channel = 0;  // of a roving sensor: index into Record::accel; else 0
  int place = 0;  // the point whose coordinates it has: another one if one place was struck in several directions
  std::optional<Direction> along{};  // of a positive value; nothing for rotations and unknown coordinate systems
  bool operator==(const PointMotion&) const = default;
};

/// Sorts by point, then channel. Of several motions of one point and channel, keeps the first.
void sort_motions(std::vector<PointMotion>& motions);

/// The motion of a point and channel in sorted `motions`, or nullptr. `channel` is 0 with a roving hammer.
const PointMotion* find_motion(const std::vector<PointMotion>& motions, int point, std::size_t channel);

/// The point whose coordinates `point` has: itself, unless sorted `motions` state another one.
int place_of_point(const std::vector<PointMotion>& motions, int point);

/// The motions of roving sensors at the chosen channels, which are numbered anew in the order of `channels`.
std::vector<PointMotion> motions_at(const std::vector<PointMotion>& motions, const std::vector<std::size_t>& channels);

/// Whether any of `some` and any of `others` move one place along one line.
bool move_alike(const std::vector<PointMotion>& some, const std::vector<PointMotion>& others);

/// Whether both geometries place the same points at the same places, and at least one. NaN stands for no place.
bool same_geometry(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b);

/// Notes once that the sensors moved in some files only.
void note_mixed_roving(std::vector<Message>& notes);

/// Adds the motions of `next` (a Record or FrfRecord) to `out`, with `after` added to its points. `after` is also added
/// to its places, unless both have the same geometry and no place moves along one line in both: each file then holds
/// another direction of the same places. `sensor_roves` remains set only if both have it; otherwise `notes` say so, and
/// the motions of the sensors are left out.
template <class Test>
void join_motions(int after, const Test& next, Test& out, std::vector<Message>& notes) {
  if (next.sensor_roves != out.sensor_roves) {
    note_mixed_roving(notes);
    if (out.sensor_roves) out.motions.clear();
    out.sensor_roves = false;
    if (next.sensor_roves) return;
  }
  const bool same_places = same_geometry(out.geometry, next.geometry) && !move_alike(next.motions, out.motions);
  for (PointMotion motion : next.motions) {
    motion.point += after;
    if (!same_places) motion.place += after;
    out.motions.push_back(motion);
  }
  sort_motions(out.motions);
}

}  // namespace percuss::acquire
