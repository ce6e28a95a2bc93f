#pragma once
#include <vector>

#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// The length of a pulse at 80 % of its peak over its length at 30 %. A half-sine has 0.51, a haversine 0.47, a
/// triangle 0.29; a half-sine cut at 80 % of its peak has 0.66. For tests.
double top_flatness(const Hit& hit);

/// Adds `force_clipped` to hits whose pulse has a flat top, although no samples are equal: an amplifier clipped the
/// force before the recorder's anti-alias filter, which rounded the corners. Leaves out hits with `overload`, and hits
/// whose samples do not show the pulse's shape: a weak, a truncated or an aliased pulse.
void grade_flat_tops(std::vector<Hit>& hits);

}  // namespace percuss::acquire
