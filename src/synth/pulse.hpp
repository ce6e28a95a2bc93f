#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::synth {

/// A force pulse f(t) = peak·p(t − onset), 0 outside its width.
struct Pulse {
  PulseKind kind = PulseKind::haversine;
  double onset_s = 0;
  double width_s = 0;
  double peak_N = 0;
};

struct SynthPole {
  double freq_Hz = 0;
  double damping_ratio = 0;
};

/// What one pulse leaves in the samples of a record; element i of an array belongs to sample first + i, beyond its end
/// is zero.
struct PulseBasis {
  std::size_t first = 0;
  std::vector<double> force_N;  // filtered force
  std::vector<std::vector<double>>
      regular_N;  // [pole]: acceleration of a mode of residue 1/kg is force + regular, in m/s²
};

/// The pulse at t seconds after its onset, N; and its integral over all time, N s.
double pulse_force_N(const Pulse& pulse, double t_s);
double pulse_impulse_Ns(const Pulse& pulse);

/// The samples [first, last) of a record that a pulse touches at all: before and after them its basis is empty. A
/// bound, cheap.
struct PulseSupport {
  double first, last;
};
PulseSupport pulse_support(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles);

/// Samples first … first + count − 1 of (filter ∗ force) and (filter ∗ modal response ∗ force), from closed forms:
/// Gauss–Legendre panels over the pulse and the filter's support, where the integrands are entire; one exact
/// exponential per pole afterwards, cut when it is below e^−42 of the peak. errors  none: frequency in (0, fs], damping
/// ratio in (0, 0.5], width > 0 are preconditions.
PulseBasis pulse_basis(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles, std::size_t first,
                       std::size_t count);

}  // namespace percuss::synth
