#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// Adds `overload` to hits whose clipping shows only in comparison with other hits. A short pulse may have one or two
/// clipped samples, which look like any peak. The clipping level is the peak of a hit with `overload` in the same file
/// and of the same sign, unless another hit exceeds it. The largest peak of this sign in the file is the level, too,
/// where three different hits have it, or two different hits with at least two samples at the peak.
void grade_force_clipping(std::vector<Hit>& hits, const Record& record);

}  // namespace percuss::acquire
