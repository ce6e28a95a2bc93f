#pragma once
#include <map>
#include <string>
#include <vector>

#include "metrics/compare.hpp"

namespace percuss::metrics {

/// The orders that the modes of two documents state within their families. Only modes whose family has a confidence of
/// 0.9 or more count. An order is a count from below, so that a mode that one document lacks moves all orders above it.
/// The common orders are therefore checked from below. Their distance is the change of ln(f_b/f_a) from the common
/// order below. If an order of one document is less than half as far from a higher order of the other, orders from here
/// on are in doubt. The orders of a family do not hold at all if no common order lies within `furthest`, relative to
/// the first document.
class CommonOrders {
 public:
  CommonOrders(const ComparedDocument& a, const ComparedDocument& b, double furthest);

  /// Whether the orders of two modes of one family decide whether the modes are the same. Each mode may be of either
  /// document.
  bool hold(const ComparedMode& x, const ComparedMode& y) const;
  /// Whether the modes differ because their orders differ. The family of one of them may be uncertain: if it is another
  /// family, the modes differ as well.
  bool tell_apart(const ComparedMode& x, const ComparedMode& y) const;
  /// The orders of a family that both documents state and that hold, ascending.
  std::map<std::string, std::vector<int>> common() const;
  std::vector<DoubtedOrders> doubted() const;

 private:
  // Whether both have an order in one family, of which the lower one holds.
  bool within_common(const ComparedMode& x, const ComparedMode& y) const;

  struct Family {
    std::vector<int> orders;  // common to both documents, ascending
    int doubted_from = 0;     // 0: none
    bool any_near = false;    // a common order lies within the limit
    bool holds(int order) const { return any_near && (doubted_from == 0 || order < doubted_from); }
  };
  std::map<std::string, Family> families_;
};

}  // namespace percuss::metrics
