#pragma once
#include <cstddef>
#include <span>

#include "frf/spectra.hpp"

namespace percuss::frf {

/// Transform of a block that is zero outside a short pulse, at the lines wanted: a third of the work of transforming
/// the zeros as well. The pulse's own transform, eight times as fine as it need be, is interpolated between its lines
/// by a Kaiser–Bessel kernel of twelve of them, whose shape is divided out of the pulse beforehand. source  [19] in
/// docs/theory/sources.md.
/// shapes  pulse [n], from sample `offset` of lines.samples on; out [lines.count], within 1e-13 of the largest line.
/// False, and nothing done, where that would not save anything: the pulse is long, or lines.samples has no factor to
/// divide by.
bool pulse_spectrum(std::span<const double> pulse, std::size_t offset, const LineRange& lines, std::span<Complex> out);

}  // namespace percuss::frf
