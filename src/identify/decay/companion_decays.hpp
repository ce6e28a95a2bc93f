#pragma once
#include "identify/decay/decay_modes.hpp"

namespace percuss::identify {

/// A mode with friction or looseness does not decay exponentially: the fit needs further decays of the same shape near
/// it, and oscillations that do not decay. Moves these from the modes and tones to the `companions` of the mode, and
/// adds their spread to the misfit part of its ±. A pair of decays stays a pair: only two companions or more are
/// gathered. Three channels or more measure the shape. Real close modes of one shape cannot be told from companions:
/// they are gathered, too.
///
/// One or two channels do not tell shapes apart. There, companions lie within the half-power bandwidth of the broader
/// decay, their decay rates differ, and in each hit the sum of all parts falls without beats while its frequency
/// changes in one direction, as for one mode whose frequency follows its amplitude. Decays that lie that near, but fail
/// these tests, stay modes; the strongest names the others as `unresolved_Hz`.
void gather_companions(DecayResults& found);

}  // namespace percuss::identify
