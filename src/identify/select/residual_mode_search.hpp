#pragma once
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss::identify {

/// Modes that show no peak of their own, each to be tried once among all that the residual shows, and broad ones once
/// more by themselves: a mode as broad as a dozen peaks looks like a dozen narrow ones, which are given up together.
class ResidualModeSearch {
 public:
  enum class SearchPass { all, alone };

  /// Poles to be tried next beside those known; none: there are no more. Not near known modes, whose close companions
  /// are found by splitting, nor near those that move from point to point.
  std::vector<Pole> next(const WindowedFit& all, SearchPass way);
  bool has_tried_any() const { return !tried_.empty(); }

 private:
  std::vector<Pole> tried_, alone_;
};

}  // namespace percuss::identify
