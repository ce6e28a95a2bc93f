#include "synth/structure.hpp"

#include <cmath>

namespace percuss::synth {
namespace {

// The n-th positive root of cos β = 1/cosh β, by Newton's method from its asymptote (n + 1/2)π.
double free_beam_root(int n) {
  double beta = (n + 0.5) * std::numbers::pi;
  for (int i = 0; i < 8; ++i) {
    const double sech = 1 / std::cosh(beta);
    beta -= (std::cos(beta) - sech) / (sech * std::tanh(beta) - std::sin(beta));
  }
  return beta;
}

}  // namespace

double free_beam_shape(int n, double x) {
  const double beta = free_beam_root(n);
  const double decay = std::exp(-beta);
  // k = 1 + tip·2e^−β/(1 − e^−2β − 2e^−β sin β) gives cosh βx − k sinh βx = e^−βx − (k − 1) sinh βx without
  // cancellation.
  const double tip = decay + std::sin(beta) - std::cos(beta);
  const double scale = 1 / (1 - decay * decay - 2 * decay * std::sin(beta));
  const double hyperbolic = std::exp(-beta * x) - tip * scale * (std::exp(-beta * (1 - x)) - std::exp(-beta * (1 + x)));
  const double k = 1 + 2 * tip * scale * decay;
  return 0.5 * (hyperbolic + std::cos(beta * x) - k * std::sin(beta * x));
}

double mode_shape_per_sqrt_kg(const SynthStructure& structure, const SynthMode& mode, double position_m,
                              double angle_rad) {
  if (mode.type == SynthModeType::bending) {
    const double from_knob = 1 - position_m / structure.length_m;
    return mode.amplitude_per_sqrt_kg * free_beam_shape(mode.order, from_knob) * std::cos(angle_rad - mode.angle_rad);
  }
  if (position_m >= structure.barrel_m) return 0;
  return mode.amplitude_per_sqrt_kg * std::sin(mode.order * std::numbers::pi * position_m / structure.barrel_m) *
         std::cos(2 * (angle_rad - mode.angle_rad));
}

double residue_per_kg(const SynthSpec& spec, std::size_t mode, std::size_t point, std::size_t sensor) {
  const SynthMode& m = spec.modes[mode];
  const SynthSensor& s = spec.sensors[sensor];
  const double recorded = s.sign * s.gain / spec.recorder.force_gain;
  if (!m.residue_per_kg.empty()) return recorded * m.residue_per_kg[point * spec.sensors.size() + sensor];
  const SynthPoint& p = spec.points[point];
  return recorded * mode_shape_per_sqrt_kg(spec.structure, m, p.position_m, p.angle_rad) *
         mode_shape_per_sqrt_kg(spec.structure, m, s.position_m, s.angle_rad);
}

double rigid_line_per_kg(const SynthSpec& spec, std::size_t point, std::size_t sensor) {
  const SynthStructure& b = spec.structure;
  const SynthSensor& s = spec.sensors[sensor];
  const double recorded = s.sign * s.gain / spec.recorder.force_gain;
  if (!b.rigid_line_per_kg.empty()) return recorded * b.rigid_line_per_kg[point * spec.sensors.size() + sensor];
  const SynthPoint& p = spec.points[point];
  return recorded * (1 / b.mass_kg + (p.position_m - b.cm_m) * (s.position_m - b.cm_m) / b.inertia_kgm2) *
         std::cos(p.angle_rad - s.angle_rad);
}

}  // namespace percuss::synth
