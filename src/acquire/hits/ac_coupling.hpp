#pragma once
#include <span>

#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// Corner frequency of a first-order high-pass in the force channel: an AC-coupled channel undershoots after each pulse
/// and returns exponentially. 0 where the force after the hit's gate shows no significant undershoot. Also 0 where
/// the undershoot is no exponential return, but a drift or a pull of the hammer. To test this, the force is integrated
/// over at most 0.25 s after the gate: the integral over the first part of this time predicts the integral over all of
/// it. `x` are the samples of the hit, baseline removed. theory (1.12)
double ac_coupling_Hz(const Hit& hit, std::span<const double> x, double fs_Hz);

}  // namespace percuss::acquire
