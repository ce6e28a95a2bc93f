#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

struct LscfOptions {
  std::size_t max_order = 40;  // number of complex poles, 2 … 100; at most a quarter of the lines
  std::size_t first = 0;       // first spectral line
  std::size_t count = 0;       // number of lines; 0: all from `first`
};

/// The poles of one model order.
struct LscfOrder {
  std::size_t order = 0;
  std::vector<Pole> poles;  // stable (decaying) poles within the lines used, ascending frequency
};

/// Least-squares complex frequency-domain estimator: the poles of all model orders from 2 up. All FRFs have a common
/// denominator,
///   H_o(k) ≈ B_o(z_k)/A(z_k),  A(z) = 1 + Σ_i a_i z^i,  i = 1 … order                                       (1)
///   z_k = exp(2πj k/L),  k = 0 … lines − 1, L > lines points on the whole circle                              (2)
///   minimise Σ_o w_o Σ_k |A(z_k) H_o(k) − B_o(z_k)|²                                                        (3)
/// The BAND is mapped to the circle, not 0 … fs/2, so that the resolution does not depend on the sampling rate. The
/// coefficients are complex: a mode is one pole without a mirror image. The free part of the circle separates the two
/// ends of the band. B_o (of degree max_order at every order) is eliminated. The normal equations of A are Toeplitz
/// sums computed by FFT. They are nested, so that one factorisation serves all orders. The constant coefficient is
/// fixed, which moves noise poles outside the unit circle, where they are unstable and omitted. w_o is one over the
/// noise variance of FRF o (LineNoise). The effect of an exponential window on the poles is undone: s = s′ + σ.
/// shapes  orders 2 … max_order, ascending; empty with fewer than 8 lines or no FRF.
/// source  [6] in docs/theory/sources.md.
/// theory (4.3), (4.4), (4.5), (4.6)
std::vector<LscfOrder> lscf_poles(const FrfDataset& set, const LscfOptions& options = {});

}  // namespace percuss::identify
