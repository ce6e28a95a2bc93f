#pragma once
#include <string>

#include "frf/estimators.hpp"

namespace percuss::frf {

enum class FrfKind { accelerance, mobility, receptance };

const char* name_of(FrfKind kind);
/// (m/s^2)/N, (m/s)/N, m/N
const char* unit_of(FrfKind kind);

/// Accelerance as mobility (÷ jω) or receptance (÷ (jω)²), value and deviation alike; a new object, the input is not
/// changed. With an exponential window of decay σ the FRF stands at s = jω + σ, and that is what it is divided by. The
/// line at s = 0 becomes 0.
/// theory (2.10)
Frf converted(const Frf& accelerance, const LineRange& lines, FrfKind kind, double decay_per_s = 0);

}  // namespace percuss::frf
