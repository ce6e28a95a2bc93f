#include "metrics/deflection/integration.hpp"

#include "core/math/fft.hpp"
#include "core/units.hpp"
#include "metrics/deflection/laplace_transform.hpp"

namespace percuss::metrics {

Motion integrate_twice(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz) {
  const LaplaceTransform transform(accel_mps2, fs_Hz);
  const double corner = kTwoPi * highpass_corner_Hz;
  const auto accel = [corner](Complex s) { return corner > 0 ? (s + corner) / s : Complex(1); };  // (1)
  return {.velocity_mps = transform.response([&](Complex s) { return accel(s) / s; }),
          .deflection_m = transform.response([&](Complex s) { return accel(s) / (s * s); })};
}

Motion small_interval_sums(std::span<const double> accel_mps2, double fs_Hz) {
  Motion motion{std::vector<double>(accel_mps2.size()), std::vector<double>(accel_mps2.size())};
  for (std::size_t i = 0; i + 1 < accel_mps2.size(); ++i) {
    motion.velocity_mps[i + 1] = motion.velocity_mps[i] + accel_mps2[i] / fs_Hz;  // (2)
    motion.deflection_m[i + 1] = motion.deflection_m[i] + motion.velocity_mps[i] / fs_Hz;
  }
  return motion;
}

Motion integrate_in_frequency_domain(std::span<const double> accel_mps2, double fs_Hz, double highpass_corner_Hz,
                                     double lowest_Hz) {
  auto lines = real_dft(accel_mps2);
  const double step = kTwoPi * fs_Hz / static_cast<double>(accel_mps2.size());
  const double corner = kTwoPi * highpass_corner_Hz;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Complex s(0, static_cast<double>(k) * step);
    const bool kept = k > 0 && s.imag() >= kTwoPi * lowest_Hz;
    lines[k] = kept ? lines[k] * (s + corner) / (s * s) : Complex(0);
  }
  Motion motion{.velocity_mps = inverse_real_dft(lines, accel_mps2.size()), .deflection_m = {}};
  for (std::size_t k = 1; k < lines.size(); ++k) lines[k] /= Complex(0, static_cast<double>(k) * step);
  motion.deflection_m = inverse_real_dft(lines, accel_mps2.size());
  return motion;
}

}  // namespace percuss::metrics
