#pragma once
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/select/mode_acceptance.hpp"

namespace percuss::identify {

/// Second modes beside known ones, where a group's residual asks for one. What was tried with no success is not tried
/// again before the group's own fit has changed.
class CloseModeSearch {
 public:
  /// The poles of all groups, with one more where a second mode is found.
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
