#pragma once
#include <span>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/hits/pulse_shape.hpp"

namespace percuss::acquire {

/// Adds `late_trigger`, `overload` and `polarity` to a hit whose pulse shows them. `x` is the force of the hit,
/// baseline removed. `starts_in_pulse`: the gate of the pulse begins at the first sample.
void grade_pulse(Hit& hit, std::span<const double> x, const PulseShape& pulse, bool starts_in_pulse);

/// Adds `weak` to hits far below the median peak.
void grade_weak(std::vector<Hit>& hits);

}  // namespace percuss::acquire
