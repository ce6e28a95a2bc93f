#pragma once
#include "synth/synthesise.hpp"

namespace percuss::synth {

/// Computes the Cramér–Rao bound of a test's frequencies and damping ratios (see CramerRaoBound) from the Fisher matrix
/// of the exact signals:
///   F = Σ_hits,channels Jᵀ J/σ_c²,  J = ∂acceleration/∂(f, ζ, residues, rigid-body accelerance)
/// The residues and the rigid-body accelerance of every point and channel are eliminated. Derivatives with respect to f
/// and ζ are central differences of the closed forms. A mode that no channel measures gets 1e99. Clipping and rounding
/// are ignored. Preconditions: every accel_noise_mps2 > 0, at least one mode. theory (4.16)
CramerRaoBound cramer_rao_bound(const Truth& truth, std::size_t threads = 0);

}  // namespace percuss::synth
