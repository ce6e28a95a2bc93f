#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::metrics {

/// Velocity and deflection at the samples of an acceleration, both zero at the first. shapes [samples].
struct Motion {
  std::vector<double> velocity_mps, deflection_m;
};

/// The integrals of a band-limited acceleration that is zero before its first sample, on the line s = σ + jω of the
/// Laplace transform, where nothing wraps around and division by s is exact:
///   V(s) = A(s)/s,  W(s) = A(s)/s²,  A(s) = Y(s)·(s + ω_c)/s                       (1)
/// ω_c = 2π·highpass_corner_Hz undoes the first-order high-pass of a charge amplifier (0: there is none). No rule of
/// integration: what lies below half of the sampling rate is integrated without error.
/// theory (7.1)
Motion integrate_twice(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz = 0);

/// The source's small-interval sums, of first order ([9] in docs/theory/sources.md):
///   v(n+1) = v(n) + a(n)·Δt,  w(n+1) = w(n) + v(n)·Δt                               (2)
/// theory (7.6)
Motion small_interval_sums(std::span<const double> accel_mps2, double fs_Hz);

/// Division by jω and (jω)² line by line of the whole record, lines below lowest_Hz left out: no drift, but what is
/// slower is lost, and a record that does not begin and end at rest wraps around.
/// theory (7.7)
Motion integrate_in_frequency_domain(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz,
                                     double lowest_Hz);

}  // namespace percuss::metrics
