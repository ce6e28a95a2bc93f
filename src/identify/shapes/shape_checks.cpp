#include "identify/shapes/shape_checks.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::identify {

std::vector<DrivingPointCheck> check_driving_points(const std::vector<Mode>& modes,
                                                    const std::vector<DrivingPoint>& driving) {
  std::vector<DrivingPointCheck> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (const DrivingPoint& at : driving) {
      const Residue* r = find_residue(modes[m], at.point, at.channel);
      if (r == nullptr) continue;
      const double std = total_std(*r);
      out.push_back({.mode = m,
                     .at = at,
                     .residue = r->value,
                     .std = std,
                     .wrong_sign = at.sign * r->value.real() < -kSignificant * std,
                     .right_sign = at.sign * r->value.real() > kSignificant * std});
    }
  }
  return out;
}

std::vector<ReciprocityCheck> check_reciprocity(const std::vector<Mode>& modes,
                                                const std::vector<std::pair<FrfIndex, FrfIndex>>& pairs) {
  std::vector<ReciprocityCheck> out;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    for (const auto& [one, other] : pairs) {
      const Residue* a = find_residue(modes[m], one.point, one.channel);
      const Residue* b = find_residue(modes[m], other.point, other.channel);
      if (a == nullptr || b == nullptr) continue;
      const double apart = std::abs(one.sign * a->value - other.sign * b->value),
                   size = std::max(std::abs(a->value), std::abs(b->value));
      const double std = std::sqrt(2.0) * std::hypot(total_std(*a), total_std(*b));  // of a complex difference
      out.push_back({.mode = m,
                     .one = one,
                     .other = other,
                     .difference = size > 0 ? apart / size : 0,
                     .deviations = std > 0 ? apart / std : 0});
    }
  }
  return out;
}

}  // namespace percuss::identify
