#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/select/mode_acceptance.hpp"

namespace percuss::identify {

/// A search for a second mode close to a known one, in groups whose residual is above the noise. A trial without
/// success is not repeated before the group's fit has changed.
class CloseModeSearch {
 public:
  /// The poles of all groups, with one more in each group where a close mode was found.
  std::vector<Pole> next(const WindowedFit& all, const AcceptanceContext& context);

 private:
  struct Tried {
    std::size_t first, count;
    std::vector<Pole> poles;
  };
  bool tried(const FitGroup& group) const;

  std::vector<Tried> tried_;
};

}  // namespace percuss::identify
