#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/math/fft.hpp"

namespace percuss::metrics {

/// The transform of a sequence on the line s = σ + jω right of the origin. The response of a causal filter does not
/// wrap around, and the filter may have poles on the imaginary axis (integrators). The sequence must be band-limited,
/// and is zero before its first sample. The rounding error at the last sample is 1e-9 of the largest value.
///   y = L⁻¹[H(s)·X(s)],  X(s) = Δt Σ x(n) exp(−s n Δt)                              (1)
/// theory (7.2)
class LaplaceTransform {
 public:
  LaplaceTransform(std::span<const double> x, double fs_Hz);

  /// (1) for H = transfer, at the samples of x.
  std::vector<double> response(const std::function<Complex(Complex s)>& transfer) const;

  /// The length of the transforms of a sequence of this length.
  static std::size_t padded_length(std::size_t samples);

 private:
  double window(std::size_t sample) const;

  double fs_Hz_;
  std::size_t samples_, padded_;
  double decay_per_s_;
  std::vector<Complex> lines_;
};

}  // namespace percuss::metrics
