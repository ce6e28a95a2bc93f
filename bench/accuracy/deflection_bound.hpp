#pragma once
#include <vector>

#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// The Cramér–Rao bound of the largest deflection of hit 0, as a relative standard deviation: [channel]. The test has
/// one point and noise in all rows. The force and the number of modes are known; frequencies, damping, residues, and
/// the bias and drift of each row are unknown.
///   F = Jᵀ J/σ_c²,  J = ∂acceleration/∂(f, ζ, A_c, bias and drift of each row)
///   σ_w² = gᵀ F⁻¹ g,  g = ∂w/∂(f, ζ, A_c)                                                              (1)
/// A_c and σ_c are the residues and the noise of channel c; w is its largest deflection, relative to its true value.
/// All channels share f and ζ.
std::vector<double> deflection_bound(const synth::Truth& truth);

}  // namespace percuss::accuracy
