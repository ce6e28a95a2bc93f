#pragma once
#include <vector>

#include "identify/fit/windowed_fit.hpp"

namespace percuss::identify {

/// Which modes the search may add: none, all that the residual shows, or one broad mode.
enum class ResidualSearch { none, all, one_broad };

/// A search of the residual for modes without a peak of their own. Each is tried once together with all others. In the
/// residual, a broad mode looks like a dozen narrow modes, and the fit rejects all of them together. A broad mode is
/// therefore tried once more, alone.
class ResidualModeSearch {
 public:
  /// The next poles to add; empty where the search is complete. None is near a known mode, whose close modes
  /// CloseModeSearch finds, nor near a mode with frequency scatter.
  std::vector<Pole> next(const WindowedFit& all, ResidualSearch which);
  bool has_tried_any() const { return !tried_.empty(); }

 private:
  std::vector<Pole> tried_, alone_;
};

}  // namespace percuss::identify
