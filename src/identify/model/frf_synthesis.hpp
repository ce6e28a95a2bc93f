#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// An FRF made again from the modes, and how well it agrees with the measured one over the band.
struct SynthesisedFrf {
  std::size_t point = 0;  // index into FrfDataset::points
  std::size_t channel = 0;
  std::vector<Complex> value;  // [lines of the band], (m/s²)/N
  std::vector<Complex> terms;  // r_0, r_2, r_4 of (1)
  double frac = 0;             // 1: the same lines up to one factor
  double noise_share = 0;      // (3), 0 … 1
  double level_dB = 0;         // root mean square of the measured lines, under the strongest FRF
};

/// Every FRF of the set from the modes' residues and what lies outside the band, fitted by least squares:
///   H(k) = Σ_r A_r φ_r(k) + r_0 + r_2 s² + r_4 s⁴,  s = jω over its value at the band's end                (1)
///   FRAC = |Σ_k conj(H) Ĥ|² / (Σ|H|² Σ|Ĥ|²)                                                              (2)
///   what changes from line to line of what is left, ε = H − Ĥ, as noise does and no mode:
///   Σ|ε(k) − (ε(k−1) + ε(k+1))/2|² / (3/2 Σ|ε|²)                                                         (3)
/// φ_r as H1 sees it, a truncated decay included (mode_column), with the point's own pole where it has one. r_0 is the
/// rigid body's line, r_2 and r_4 begin the series of what modes above the band add. shapes  modes' residues in the
/// order of set.channels; `band` within set.lines. source  [4] in docs/theory/sources.md.
/// theory (5.5)
std::vector<SynthesisedFrf> synthesised_frfs(const FrfDataset& set, const std::vector<Mode>& modes,
                                             const frf::LineRange& band);

/// FRAC (2) of two FRFs; 0 when either is zero everywhere.
double frac(const std::vector<Complex>& measured, const std::vector<Complex>& made);

}  // namespace percuss::identify
