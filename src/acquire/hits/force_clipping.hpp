#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// Adds `overload` to hits whose clipping shows only beside other hits. A short pulse may have one or two clipped
/// samples, which look like any peak. The clipping level is the peak of an `overload` of the same file and sign, unless
/// another hit exceeds it. Three different hits with exactly one peak value, or two with two samples at it, also give
/// the level.
void grade_force_clipping(std::vector<Hit>& hits, const Record& record);

}  // namespace percuss::acquire
