#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Poles of one rational function for all FRFs, by vector fitting: `count` pairs of poles are first spread evenly over
/// the lines. Each of ten iterations moves them to the zeros of a weight function σ that is fitted together with σ H,
///   σ(s) H_o(s) ≈ s² Σ_m (R_om/(s − λ_m) + …) + residual terms,  σ(s) = d + Σ_m (c_m/(s − λ_m) + …)           (1)
/// Two FRFs suffice for tens of modes that overlap, where the stabilisation diagram shows only some of them. Needs no
/// start values; a count larger than the number of modes adds poles that follow noise. Lines are averaged over
/// `resolution_Hz`, a fraction of the narrowest bandwidth, and weighted by their noise (LineNoise). Truncation of the
/// decays is ignored.
/// Returns the poles within the lines, ascending, at most `count`. Empty where there are too few lines for so many.
/// source  [23], [24] in docs/theory/sources.md.
/// theory (4.26)
std::vector<Pole> vector_fitting_poles(const FrfDataset& set, std::size_t count, double resolution_Hz);

}  // namespace percuss::identify
