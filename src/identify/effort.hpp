#pragma once

namespace percuss {

/// How much work goes into the modes. Run times are those of a whole analysis of five hits with a close pair, over that
/// of bare transforms of the same records; errors those of frequencies, over the Cramér–Rao bound.
enum class Effort {
  quick,     // each mode over its own lines; close pairs and hidden modes are looked for in three rounds: 12 times, 1.7
  standard,  // … in as many as it takes: no different where there are few
  best,      // … and all of them together: 32 times, 1.0
};
const char* name_of(Effort effort);

}  // namespace percuss
