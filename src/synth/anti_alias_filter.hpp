#pragma once
#include <array>
#include <cstddef>

namespace percuss::synth {

/// Half the support of the anti-alias filter, in samples: a sample feels what happens this far on either side.
inline constexpr double kFilterHalfWidth = 64;

/// The recorder's anti-alias filter at u samples from its centre, 1/sample: a sinc of cut-off 0.45 fs under a Gaussian
/// that has fallen to e^−37 at ±kFilterHalfWidth. Linear phase, no delay; 1 to within 2e-12 below 0.30 fs and 0 above
/// 0.60 fs, so that aliases leave an FRF exact to 1e-11 below 0.40 fs and to 1e-6 at 0.44 fs.
double anti_alias_kernel(double u);

/// Gauss–Legendre rule on [0, 1]: on panels of one or two samples its error for what passes the filter is far below
/// rounding.
inline constexpr std::size_t kGaussNodes = 16;
struct GaussLegendre {
  std::array<double, kGaussNodes> x{}, weight{};
};
const GaussLegendre& gauss_legendre();

}  // namespace percuss::synth
