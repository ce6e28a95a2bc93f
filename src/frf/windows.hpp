#pragma once
#include <span>

namespace percuss::frf {

/// Multiplies x[n] by exp(−decay·(n − origin)/fs). Force and response carry the same window without an amplitude
/// factor, so that their ratio at jω is exactly the FRF at jω + decay. The window is 1 at the sample `origin`.
void apply_exponential(std::span<double> x, double decay_per_s, double fs_Hz, double origin);

/// The decay (1/s) at which the window falls from 1 to `fraction` in `duration_s`.
/// theory (2.2)
double decay_for_end(double fraction, double duration_s);

}  // namespace percuss::frf
