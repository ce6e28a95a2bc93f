#pragma once
#include <cstddef>

#include "model/beam/beam.hpp"

namespace percuss::model {

/// An elastic mode (counted from 1) of a uniform Timoshenko beam, by the exact solutions of
///   EI φ'' + κGA (w' − φ) + ρI ω² φ = 0,   κGA (w'' − φ') + ρA ω² w = 0                             (1)
/// which are sin and cos of λξ and exponentials of δξ, with β = λ/L, α = δ/L, g = ρA ω²/κGA:
///   2 β⁴/ω² = P + √(P² − 4 ρA ρI β⁴/(κGA EI)),  P = ρA/EI + β² (ρA/κGA + ρI/EI)                     (2)
///   α² β² = ω² (ρA/EI) (1 − ω² ρI/κGA)                                                              (3)
/// The frequency is the root in β of the determinant of the four conditions at the ends. Each has its own bracket: with
/// both ends free, or pinned and free, a branch of tan(βL/2) or tan(βL); with a spring or a clamp, the neighbouring
/// roots of the pinned beam, as one spring moves no frequency past the next. `support` as it is there: a spring's
/// stiffness is above zero and finite.
/// errors  InputError above the frequency √(κGA/ρI), from where two kinds of wave run along the beam.
/// theory (8.7), (8.8), (8.9)
BeamMode timoshenko_mode(const UniformBeam& beam, std::size_t elastic);

}  // namespace percuss::model
