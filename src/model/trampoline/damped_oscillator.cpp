#include "model/trampoline/damped_oscillator.hpp"

#include <cmath>

namespace percuss::model {

OscillatorState DampedOscillator::after(const OscillatorState& start, double time_s) const {
  const double square = (omega_radps - decay_radps) * (omega_radps + decay_radps);
  const double rate = std::sqrt(std::abs(square));
  double cosine = 0, sine = 0;  // both multiplied by exp(−σt), the sine divided by the rate
  if (rate * time_s == 0) {
    cosine = std::exp(-decay_radps * time_s);
    sine = time_s * cosine;
  } else if (square > 0) {
    const double envelope = std::exp(-decay_radps * time_s);
    cosine = envelope * std::cos(rate * time_s);
    sine = envelope * std::sin(rate * time_s) / rate;
  } else {  // cosh and sinh from the slower exponential, which cannot overflow
    const double slow = std::exp((rate - decay_radps) * time_s), gap = std::expm1(-2 * rate * time_s);
    cosine = slow * (1 + gap / 2);
    sine = -slow * gap / (2 * rate);
  }
  const double push = start.v_mps + decay_radps * start.x_m;
  return {.x_m = start.x_m * cosine + push * sine,
          .v_mps = start.v_mps * cosine - (decay_radps * start.v_mps + omega_radps * omega_radps * start.x_m) * sine};
}

double DampedOscillator::amplitude_bound_m(const OscillatorState& start) const {
  return std::hypot(start.x_m, start.v_mps / omega_radps);
}

}  // namespace percuss::model
