#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// Check of a driving point's residue, which must have the sign of the driving point.
struct DrivingPointCheck {
  std::size_t mode = 0;
  DrivingPoint at;
  Complex residue;
  double std = 0;
  bool wrong_sign = false;  // real part of the other sign by more than 3 standard deviations
  bool right_sign = false;  // real part of the driving point's sign by more than 3 standard deviations
};
std::vector<DrivingPointCheck> check_driving_points(const std::vector<Mode>& modes,
                                                    const std::vector<DrivingPoint>& driving);

/// Reciprocity check: the residues of H(p, q) and H(q, p) in one mode must be equal, each times its sign.
struct ReciprocityCheck {
  std::size_t mode = 0;
  FrfIndex one, other;
  double difference = 0;  // |A_pq − A_qp| over the larger magnitude
  double deviations = 0;  // |A_pq − A_qp| over its standard deviation
};
/// `pairs`: each holds the FRFs H(p, q) and H(q, p) of the same two places, with the signs of the driving points at the
/// sensors q and p.
std::vector<ReciprocityCheck> check_reciprocity(const std::vector<Mode>& modes,
                                                const std::vector<std::pair<FrfIndex, FrfIndex>>& pairs);

}  // namespace percuss::identify
