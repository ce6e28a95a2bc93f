#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// A driving point's residue against the rule that it is positive.
struct DrivingPointCheck {
  std::size_t mode = 0;
  DrivingPoint at;
  Complex residue;
  double std = 0;
  bool wrong_sign = false;  // negative, or turned by more than 90°, by more than 3 deviations
};
std::vector<DrivingPointCheck> check_driving_points(const std::vector<Mode>& modes,
                                                    const std::vector<DrivingPoint>& driving);

/// H(p, q) against H(q, p): two residues of one mode that must be equal.
struct ReciprocityCheck {
  std::size_t mode = 0;
  DrivingPoint one, other;
  double difference = 0;  // |A_pq − A_qp| over the larger of both
  double deviations = 0;  // the same in its standard deviations
};
/// `pairs` names the (point, channel) that measure the same two places both ways round.
std::vector<ReciprocityCheck> check_reciprocity(const std::vector<Mode>& modes,
                                                const std::vector<std::pair<DrivingPoint, DrivingPoint>>& pairs);

}  // namespace percuss::identify
