#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "acquire/record/frf.hpp"
#include "frf/spectra.hpp"

namespace percuss::frf {

enum class Estimator { h1, h2, hv };

/// H1, H2, Hv
const char* name_of(Estimator estimator);

/// Spectra of several hits are summed in blocks of this many lines, whose sums fit into the first-level cache.
inline constexpr std::size_t kLinesPerBlock = 256;

/// Cross and auto spectra, summed over the hits at each spectral line. They are one-sided and not scaled: only their
/// ratios are used.
///   G_ff = Σ |F|²,  G_aa = Σ |A|²,  G_fa = Σ conj(F) A
/// theory (2.3)
struct CrossSpectra {
  std::vector<double> ff, aa;
  std::vector<Complex> fa;
  std::size_t averages = 0;
};

/// shapes  force and accel [hits][lines], of the same hits in the same order.
CrossSpectra cross_spectra(std::span<const std::span<const Complex>> force,
                           std::span<const std::span<const Complex>> accel);

using acquire::Frf;

/// The accelerance from the summed spectra of force and acceleration.
///   H1 = G_fa / G_ff                    unbiased by noise on the acceleration                          (1)
///   H2 = G_aa / conj(G_fa)              unbiased by noise on the force                                 (2)
///   Hv = total least squares: a/f of the eigenvector (f, a) of [[G_ff, conj G_fa], [G_fa, G_aa]] with the larger
///        eigenvalue, both channels scaled to the same mean power over these lines                        (3)
///   γ² = |G_fa|² / (G_ff G_aa)                                                                         (4)
///   σ² = (1 − γ²)/γ² · |H1|² / (n − 1), n hits                                                         (5)
/// shapes  every array [lines].
/// units   (m/s²)/N.
/// errors  InputError: the force has no energy at some spectral line (G_ff = 0).
/// source  [3], [4] in docs/theory/sources.md.
/// theory (2.4), (2.5), (2.6), (2.7), (2.8) in the order of (1) to (5) here
Frf estimate_frf(const CrossSpectra& spectra, const LineRange& lines, Estimator estimator = Estimator::h1);

/// Throws InputError where the force has no energy at some spectral line. shape  ff [lines.count]
void require_force(std::span<const double> ff, const LineRange& lines);

}  // namespace percuss::frf
