#pragma once
#include <span>

namespace percuss::frf {

/// Multiplies x[n] by exp(−decay·(n − origin)/fs): the same on force and response, without any amplitude factor, so
/// that their ratio at jω is the FRF at jω + decay exactly. decay in 1/s; `origin` is the sample where the window is 1.
void apply_exponential(std::span<double> x, double decay_per_s, double fs_Hz, double origin);

/// The decay that brings the window from 1 to `fraction` in `duration_s`.
/// theory (2.2)
double decay_for_end(double fraction, double duration_s);

}  // namespace percuss::frf
