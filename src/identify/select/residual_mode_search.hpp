#pragma once
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss::identify {

/// Which modes the search may add: none, all that the residual shows, or one broad mode.
enum class ResidualSearch { none, all, one_broad };

/// Modes that show no peak of their own, each to be tried once among all that the residual shows, and broad ones once
/// more by themselves: a mode as broad as a dozen peaks looks like a dozen narrow ones, which are given up together.
class ResidualModeSearch {
 public:
  /// Poles to be tried next beside those known; none: there are no more. Not near known modes, whose close companions
  /// are found by splitting, nor near those that move from point to point.
  std::vector<Pole> next(const WindowedFit& all, ResidualSearch which);
  bool has_tried_any() const { return !tried_.empty(); }

 private:
  std::vector<Pole> tried_, alone_;
};

}  // namespace percuss::identify
