#pragma once
#include <array>
#include <cstddef>

namespace percuss::synth {

/// Half the support of the anti-alias filter in samples: a sample depends on the signal this far on either side.
inline constexpr double kFilterHalfWidth = 64;

/// The kernel of the recorder's anti-alias filter at u samples from its centre, 1/sample: a sinc of cut-off 0.45 fs
/// times a Gaussian that falls to e^−37 at ±kFilterHalfWidth. The filter has linear phase and no delay. Its gain is 1
/// to within 2e-12 below 0.30 fs and 0 above 0.60 fs. The error of an FRF due to aliases is 1e-11 below 0.40 fs and
/// 1e-6 at 0.44 fs.
double anti_alias_kernel(double u);

/// Gauss–Legendre rule on [0, 1]. On panels of one or two samples its error for a filtered signal is far below
/// rounding.
inline constexpr std::size_t kGaussNodes = 16;
struct GaussLegendre {
  std::array<double, kGaussNodes> x{}, weight{};
};
const GaussLegendre& gauss_legendre();

}  // namespace percuss::synth
