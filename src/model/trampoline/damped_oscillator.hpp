#pragma once

namespace percuss::model {

/// The position and the velocity of a linear oscillator.
struct OscillatorState {
  double x_m = 0, v_mps = 0;
};

/// A free oscillator, ẍ + 2σẋ + ω²x = 0, with any damping.
struct DampedOscillator {
  double omega_radps = 1, decay_radps = 0;  // ω > 0, σ ≥ 0

  /// The state time_s after `start`, in closed form.
  OscillatorState after(const OscillatorState& start, double time_s) const;
  /// An upper bound of |x| after `start`: the energy never rises.
  double amplitude_bound_m(const OscillatorState& start) const;
};

}  // namespace percuss::model
