#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// An FRF synthesised from the modes, and its agreement with the measured FRF over the band.
struct SynthesisedFrf {
  std::size_t point = 0;  // index into FrfDataset::points
  std::size_t channel = 0;
  std::vector<Complex> value;  // [lines of the band], (m/s²)/N
  std::vector<Complex> terms;  // r_0, r_2, r_4, r_6 of (1)
  double frac = 0;             // 1: equal up to one factor
  double noise_share = 0;      // (3), 0 … 1
  double level_dB = 0;         // rms of the measured FRF, relative to the strongest FRF
};

/// Every FRF of the set from the modes' residues and four residual terms, which are fitted by least squares:
///   H(k) = Σ_r A_r φ_r(k) + r_0 + r_2 s² + r_4 s⁴ + r_6 s⁶,  s = jω/ω_end, ω_end at the band's end        (1)
///   FRAC = |Σ_k conj(H) Ĥ|² / (Σ|H|² Σ|Ĥ|²)                                                              (2)
///   noise share of the residual ε = H − Ĥ, which is rough from line to line where it is noise:
///   Σ|ε(k) − (ε(k−1) + ε(k+1))/2|² / (3/2 Σ|ε|²)                                                         (3)
/// Under an exponential window of decay σ, s = (jω + σ)/ω_end. φ_r includes the truncated decay (mode_column),
/// with the point's own pole where it has one. r_0 is the mass line; r_2, r_4 and r_6 are the first terms of the series
/// for the modes above the band.
/// shapes  modes' residues in the order of set.channels; `band` within set.lines.
/// source  [4] in docs/theory/sources.md.
/// theory (5.5)
std::vector<SynthesisedFrf> synthesised_frfs(const FrfDataset& set, const std::vector<Mode>& modes,
                                             const acquire::LineRange& band);

/// The sum over the modes in (1) for each FRF, [channels][lines of the set].
std::vector<Eigen::VectorXcd> modal_sums(const FrfDataset& set, const std::vector<Mode>& modes);

/// synthesised_frfs() from modal_sums() of the same set and modes.
std::vector<SynthesisedFrf> frfs_from_sums(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums,
                                           const acquire::LineRange& band);

/// What remains of each FRF without the modes and the four residual terms, from modal_sums() of the same set and modes.
/// shape  [channels][lines of the set]
std::vector<Eigen::VectorXcd> residuals_from_sums(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& sums);

/// FRAC (2) of two FRFs; 0 where either FRF is zero everywhere.
double frac(std::span<const Complex> measured, std::span<const Complex> synthesised);

}  // namespace percuss::identify
