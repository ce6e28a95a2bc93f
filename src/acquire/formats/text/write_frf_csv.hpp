#pragma once
#include <string>

#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {

/// FRFs as CSV: frequency_hz, then per point and channel re, im, std, coherence (the last two empty where not known).
/// A `#` comment states kind, unit, estimator, angles and window. The values are converted to `kind`.
std::string frf_record_csv(const FrfRecord& record, FrfKind kind);

}  // namespace percuss::acquire
