#pragma once
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/record/point_motion.hpp"

namespace percuss::acquire {

/// −1 for a negative direction, else 1.
double uff_sign(const UffDof& dof);

/// The factor, 1 or −1, that turns a response to a force into the response along a positive direction to a force along
/// a positive direction. A pressure has no direction.
double uff_sign(const UffFunction& response, const UffDof& struck);

/// The unit vector of a direction ±1, ±2 or ±3 with the sign +, in the node's displacement coordinate system. Nothing
/// for other directions, or where that system is not known.
std::optional<Direction> uff_axis(const UffContents& contents, const UffDof& dof);

/// The point numbers of struck degrees of freedom. If every node was struck in one direction, points are numbered as
/// nodes. Otherwise a node holds one point per direction: the n-th direction in the file adds (n − 1)·S to the number
/// of the node, where S is a power of ten above all node numbers.
class UffStruckPoints {
 public:
  /// `struck`: node and unsigned direction of each force.
  UffStruckPoints(const std::set<std::pair<int, int>>& struck, const UffContents& contents);

  /// The point of a force, numbered as the nodes: the caller subtracts UffAnnotation::node_offset.
  std::int64_t point(const UffDof& struck) const;
  bool several_per_node() const { return step_ > 0; }
  /// "a node was struck in several directions, each of which is a point: point n is node n in x, 100 + n is node n in
  /// y".
  std::string note() const;

 private:
  std::vector<int> directions_;  // unsigned, ascending
  std::int64_t step_ = 0;        // 0: one direction at each node
};

/// Adds the motion of a point: its direction, if the file states it, and its place. Adds nothing if the file states no
/// direction and the place has the same number as the point.
void add_uff_motion(const UffContents& contents, const UffDof& dof, int point, std::size_t channel, int place,
                    std::vector<PointMotion>& motions);

/// "the sign of 5 of 56 FRFs is changed: …"
std::string uff_sign_note(std::size_t changed, std::size_t all, const char* what);

}  // namespace percuss::acquire
