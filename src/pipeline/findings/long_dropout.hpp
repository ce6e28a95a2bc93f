#pragma once
#include <cstddef>
#include <optional>
#include <span>

namespace percuss::pipeline {

/// A run of equal samples in a decay: the recorder or a cable delivered one value in place of the motion.
struct LongDropout {
  std::size_t first = 0, count = 0;
  bool to_end = false;  // the signal does not come back
};

/// The longest run of equal samples, from sample `first` (after the pulse) on, that is too long for diagnose_samples to
/// replace. A coarsely quantised signal also has equal samples without a dropout: in the silence after a decay, and at
/// the crests of a slow oscillation. A run therefore counts only if motion of many quantisation steps is expected from
/// the decay before it, and if it begins or ends with a corner. Runs at the largest magnitude are clipping.
std::optional<LongDropout> find_long_dropout(std::span<const double> x, std::size_t first);

}  // namespace percuss::pipeline
