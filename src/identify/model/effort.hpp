#pragma once

namespace percuss::identify {

/// How much work goes into the modes. Run times are those of a whole analysis of five hits with a close pair, over that
/// of bare transforms of the same records in memory; errors those of frequencies, over the Cramér–Rao bound.
enum class Effort {
  quick,     // peaks, each over its own lines, and pairs where one does not fit: 2.1 times, 2.0
  standard,  // … over more lines, and modes that show no peak: 3.0 times, 1.7
  best,      // … and all of them together: 15 times, 1.0
};
const char* name_of(Effort effort);

}  // namespace percuss::identify
