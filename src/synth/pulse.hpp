#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::synth {

/// A force pulse f(t) = peak·p(t − onset), zero outside its width.
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

/// The contribution of one pulse to the samples of a record. Element i of an array belongs to sample first + i; samples
/// beyond its end are zero.
struct PulseBasis {
  std::size_t first = 0;
  std::vector<double> force_N;  // filtered force
  /// [pole]: the filtered force convolved with the mode's impulse response in acceleration, without its Dirac impulse
  /// at t = 0. The acceleration of a mode with a residue of 1 kg⁻¹ is force_N + regular_N, in m/s².
  std::vector<std::vector<double>> regular_N;
};

/// The force at t_s after the onset.
double pulse_force_N(const Pulse& pulse, double t_s);

/// Bounds of the samples [first, last) of a record to which a pulse can contribute.
struct PulseSupport {
  double first, last;
};
PulseSupport pulse_support(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles);

/// Computes samples first … first + count − 1 of (filter ∗ force) and (filter ∗ modal response ∗ force). Within the
/// pulse and the filter's support the integrands are entire functions, integrated on Gauss–Legendre panels. After that
/// each pole has one exact exponential, truncated below e^−42 of the peak.
/// Preconditions: frequency in (0, fs], damping ratio in (0, 0.5], width > 0.
PulseBasis pulse_basis(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles, std::size_t first,
                       std::size_t count);

}  // namespace percuss::synth
