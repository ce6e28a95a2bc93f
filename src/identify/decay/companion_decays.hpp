#pragma once
#include "identify/decay/decay_modes.hpp"

namespace percuss::identify {

/// A mode with friction or looseness does not decay exponentially: the fit needs further decays of the same shape near
/// it, and oscillations that do not decay. Moves these from the modes and tones to the `companions` of the mode, and
/// adds their spread to the misfit part of its ±. A pair of decays stays a pair: only two companions or more are
/// gathered, and only where three channels or more measure the shape. Real close modes of one shape
/// cannot be told from companions: they are gathered, too.
void gather_companions(DecayResults& found);

}  // namespace percuss::identify
