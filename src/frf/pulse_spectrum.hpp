#pragma once
#include <cstddef>
#include <span>

#include "frf/spectra.hpp"

namespace percuss::frf {

/// The spectrum of a block that is zero outside a short pulse, at a third of the work of transforming the whole block.
/// The pulse alone is transformed, eight times oversampled, and interpolated by a Kaiser–Bessel kernel of twelve
/// spectral lines. The pulse is divided by the kernel's inverse transform beforehand.
/// source  [19] in docs/theory/sources.md.
/// shapes  pulse [n] starts at sample `offset` of lines.samples; out [lines.count], within 1e-13 of the largest line.
/// Returns false and leaves `out` unchanged if this saves no work: the pulse is long, or lines.samples has no
/// suitable factor.
bool pulse_spectrum(std::span<const double> pulse, std::size_t offset, const LineRange& lines, std::span<Complex> out);

}  // namespace percuss::frf
