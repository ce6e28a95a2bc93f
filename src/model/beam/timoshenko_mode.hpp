#pragma once
#include <cstddef>

#include "model/beam/beam.hpp"

namespace percuss::model {

/// Computes an elastic mode (counted from 1) of a uniform Timoshenko beam from the exact solutions of
///   EI φ'' + κGA (w' − φ) + ρI ω² φ = 0,   κGA (w'' − φ') + ρA ω² w = 0                             (1)
/// The solutions are sin and cos of λξ and exponentials of δξ, with β = λ/L, α = δ/L, g = ρA ω²/κGA:
///   2 β⁴/ω² = P + √(P² − 4 ρA ρI β⁴/(κGA EI)),  P = ρA/EI + β² (ρA/κGA + ρI/EI)                     (2)
///   α² β² = ω² (ρA/EI) (1 − ω² ρI/κGA)                                                              (3)
/// The frequency is the root in β of the determinant of the four boundary conditions. Each root has its own bracket.
/// With free-free or pinned-free ends the bracket is a branch of tan(βL/2) or tan(βL). With a spring or a clamp the
/// neighbouring roots of the pinned beam bracket the root, because one spring moves no frequency past the next.
/// Precondition: a spring's stiffness is above zero and finite.
/// errors  InputError above the angular frequency ω = √(κGA/ρI): there two kinds of wave run along the beam.
/// theory (8.7), (8.8), (8.9)
BeamMode timoshenko_mode(const UniformBeam& beam, std::size_t elastic);

}  // namespace percuss::model
