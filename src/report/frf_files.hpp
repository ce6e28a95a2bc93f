#pragma once
#include <string>

#include "frf/convert.hpp"
#include "pipeline/analysis.hpp"

namespace percuss {

/// FRFs as CSV: frequency_hz, then per point and channel re, im, std, coherence (the last two empty for a single hit).
/// One line of
/// `#` comment states kind, unit and estimator. The band's lines only. Throws InputError when the file exists (without
/// force) or cannot be written; the file is whole or absent.
void write_frf_csv(const std::string& path, const Analysis& analysis, FrfKind kind, bool force);
std::string frf_csv(const Analysis& analysis, FrfKind kind);

/// FRFs as HDF5: /frequency_hz [lines], /frf {r,i} [points, channels, lines], /frf_std and /coherence alike (absent for
/// single hits); attributes kind, unit, estimator, averages.
void write_frf_hdf5(const std::string& path, const Analysis& analysis, FrfKind kind, bool force);

}  // namespace percuss
