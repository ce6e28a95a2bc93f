#pragma once
#include <vector>

#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// Cramér and Rao's bound of the largest deflection for who knows the force and how many modes there are, not their
/// frequencies, damping and residues, nor each record's bias and drift: relative deviation, [channel], of hit 0 of a
/// test of one point whose rows all have noise.
///   F = Jᵀ J/σ_c²,  J = ∂acceleration/∂(f, ζ, A_c, bias and drift of each row);  σ_w² = gᵀ F⁻¹ g,  g = ∂w/∂(f, ζ, A_c)
///   (1)
/// f and ζ are the same for all channels.
std::vector<double> deflection_bound(const synth::Truth& truth);

}  // namespace percuss::accuracy
