#pragma once
#include <string>

#include "frf/estimators.hpp"

namespace percuss::frf {

enum class FrfKind { accelerance, mobility, receptance };

const char* name_of(FrfKind kind);
/// (m/s^2)/N, (m/s)/N, m/N
const char* unit_of(FrfKind kind);

/// The accelerance as mobility (÷ jω) or receptance (÷ (jω)²): values and standard deviations. The input is not
/// changed. An exponential window of decay σ moves the FRF to s = jω + σ, which is then the divisor. The spectral line
/// at s = 0 becomes 0.
/// theory (2.10)
Frf converted(const Frf& accelerance, const LineRange& lines, FrfKind kind, double decay_per_s = 0);

}  // namespace percuss::frf
