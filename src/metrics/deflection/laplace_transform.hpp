#pragma once
#include <functional>
#include <span>
#include <vector>

#include "core/math/fft.hpp"

namespace percuss::metrics {

/// A sequence's transform on the line s = σ + jω right of the origin: what a causal filter makes of it comes back
/// without wrapping around, and poles on the imaginary axis (integrators) do no harm. The sequence is taken as
/// band-limited and as zero before its first sample; 1e-9 of the largest value is what rounding leaves at the last.
///   y = L⁻¹[H(s)·X(s)],  X(s) = Δt Σ x(n) exp(−s n Δt)                              (1)
/// theory (7.2)
class LaplaceTransform {
 public:
  LaplaceTransform(std::span<const double> x, double fs_Hz);

  /// (1) for H = transfer, at the samples of x.
  std::vector<double> response(const std::function<Complex(Complex s)>& transfer) const;

 private:
  double window(std::size_t sample) const;

  double fs_Hz_;
  std::size_t samples_, padded_;
  double decay_per_s_;
  std::vector<Complex> lines_;
};

}  // namespace percuss::metrics
