#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

struct LscfOptions {
  std::size_t max_order = 40;  // one complex pole each, 2 … 100; lowered to a quarter of the lines
  std::size_t first = 0;       // the lines used
  std::size_t count = 0;       // … 0: all from `first`
};

/// What one model order gives.
struct LscfOrder {
  std::size_t order = 0;
  std::vector<Pole> poles;  // within the lines used and stable, ascending frequency
};

/// Poles of all model orders from 2 up, common to all channels: least squares in the frequency domain with a common
/// denominator,
///   H_o(k) ≈ B_o(z_k)/A(z_k),  A(z) = 1 + Σ_i a_i z^i,  i = 1 … order                                       (1)
///   z_k = exp(2πj k/L),  k = 0 … lines − 1, L > lines points on the whole circle                              (2)
///   minimise Σ_o w_o Σ_k |A(z_k) H_o(k) − B_o(z_k)|²                                                        (3)
/// The BAND is mapped to the circle, not 0 … fs/2: what is close in the band's lines is close on the circle whatever
/// the sampling rate. Coefficients are complex, so that a mode is one pole and needs no mirror image; the part of the
/// circle that is left over keeps the band's two ends apart. B_o (of degree max_order at every order) is eliminated;
/// the normal equations of A are Toeplitz sums made by FFT, and one factorisation serves all orders, whose equations
/// are nested. Fixing the constant coefficient sends the poles of the noise out of the unit circle, where they are
/// unstable and left out. w_o is one over the variance of the channel's noise as LineNoise tells it.
/// An exponential window of the force is taken off the poles. shapes: orders 2 … max_order, ascending; empty with fewer
/// than 8 lines or no channel.
/// source  [6] in docs/theory/sources.md.
/// theory (4.3), (4.4), (4.5), (4.6)
std::vector<LscfOrder> lscf_poles(const FrfDataset& set, const LscfOptions& options = {});

}  // namespace percuss::identify
