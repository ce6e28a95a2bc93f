#pragma once
#include <cmath>

namespace percuss::identify {

/// The parts of a standard deviation. Their root sum of squares is the standard deviation.
struct StdParts {
  double noise = 0;   // of the channels
  double hits = 0;    // scatter between the hits beyond the noise; 0: not significant
  double misfit = 0;  // structure of the residual that neither explains; 0: not significant
  double total() const { return std::hypot(noise, hits, misfit); }
};

}  // namespace percuss::identify
