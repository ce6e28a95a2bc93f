#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::metrics {

/// Velocity and deflection at the samples of an acceleration. shapes [samples].
struct Motion {
  std::vector<double> velocity_mps, deflection_m;
};

/// Integrates a band-limited acceleration that is zero before its first sample. On a line s = σ + jω of the Laplace
/// transform with σ > 0 the results do not wrap around in time, and division by s is exact:
///   V(s) = A(s)/s,  W(s) = A(s)/s²,  A(s) = Y(s)·(s + ω_c)/s                       (1)
/// Y is the transform of the recorded acceleration. ω_c = 2π·highpass_corner_Hz compensates the first-order high-pass
/// of a charge amplifier (0: none). There is no quadrature error below half the sampling rate. Velocity and deflection
/// begin at zero.
/// theory (7.1)
Motion integrate_twice(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz = 0);

/// Integrates by the source's small-interval sums, of first order ([9] in docs/theory/sources.md):
///   v(n+1) = v(n) + a(n)·Δt,  w(n+1) = w(n) + v(n)·Δt                               (2)
/// theory (7.6)
Motion small_interval_sums(std::span<const double> accel_mps2, double fs_Hz);

/// Divides each spectral line of the whole record by jω and (jω)², and sets lines below lowest_Hz to zero. There is no
/// drift, but slower motion is lost, and a record that does not begin and end at rest wraps around. Velocity and
/// deflection have a mean of zero; the caller subtracts their values at a time of rest.
/// theory (7.7)
Motion integrate_in_frequency_domain(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz,
                                     double lowest_Hz);

}  // namespace percuss::metrics
