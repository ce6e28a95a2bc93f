#pragma once

namespace percuss::model {

/// x and ẋ of a linear oscillator.
struct OscillatorState {
  double x_m = 0, v_mps = 0;
};

/// A free oscillator, ẍ + 2σẋ + ω²x = 0, some time after a state: in closed form, whatever its damping.
struct DampedOscillator {
  double omega_radps = 1, decay_radps = 0;  // ω > 0, σ ≥ 0

  OscillatorState after(const OscillatorState& start, double time_s) const;
  /// What |x| never exceeds from there on: the energy only falls.
  double amplitude_bound_m(const OscillatorState& start) const;
};

}  // namespace percuss::model
