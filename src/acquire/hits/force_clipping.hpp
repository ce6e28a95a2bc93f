#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// A short pulse may touch the recorder's rail with one or two samples, which by themselves look like any peak. Adds
/// `overload` to the hits that peak exactly where an `overload` of the same file shows the rail, unless another hit of
/// that file goes further: then that was no rail. Three unlike hits that peak at one number, or two with two samples at
/// it, show a rail as well.
void grade_force_clipping(std::vector<Hit>& hits, const Record& record);

}  // namespace percuss::acquire
