#include "identify/decay/decay_spectra.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/units.hpp"

namespace percuss::identify {

DecaySpectra decay_spectra(const FreeDecays& decays) {
  DecaySpectra out{.fs_Hz = decays.fs_Hz,
                   .samples = decays.samples(),
                   .hits = decays.hits,
                   .channels = decays.channels,
                   .lines = {}};
  out.lines.resize(static_cast<Eigen::Index>(out.samples / 2 + 1), static_cast<Eigen::Index>(decays.response.size()));
  for (std::size_t i = 0; i < decays.response.size(); ++i) {
    auto column = out.lines.col(static_cast<Eigen::Index>(i));
    real_dft(decays.response[i], std::span<Complex>(column.data(), static_cast<std::size_t>(column.size())));
  }
  return out;
}

Pole DecayRate::pole() const {
  const double omega = std::abs(rate_radps);
  return {.freq_Hz = omega / kTwoPi, .damping_ratio = -rate_radps.real() / omega};
}

DecayRate decay_rate_of(const Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  return {omega * Complex(-zeta, std::sqrt(std::max(0.0, 1 - zeta * zeta)))};
}

DecayColumns decay_columns(const DecayRate& rate, const DecaySpectra& of, std::size_t first, std::size_t count) {
  const double dt_s = 1 / of.fs_Hz, n = static_cast<double>(of.samples);
  const auto rows = static_cast<Eigen::Index>(count);
  DecayColumns out{.value = Eigen::MatrixX2cd(rows, 2), .slope = Eigen::MatrixX2cd(rows, 2)};
  const Complex s = rate.rate_radps * dt_s, at_end = std::exp(n * s), step = std::exp(s);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double w = kTwoPi * static_cast<double>(first + static_cast<std::size_t>(i)) / n;
    const Complex phasor = std::polar(1.0, -w);  // a recurrence would lose digits of 1 − q near the resonance
    const auto kernel = [&](Complex one_step, Complex z_n) {
      const Complex q = one_step * phasor, rest = 1.0 - q, r = std::conj(rest) / std::norm(rest);
      const Complex value = (1.0 - z_n) * r;
      return std::pair(value, dt_s * r * (value * q - n * z_n));
    };
    const auto [d, d1] = kernel(step, at_end);
    const auto [m, m1] = kernel(std::conj(step), std::conj(at_end));
    out.value(i, 0) = 0.5 * (d + m);
    out.value(i, 1) = Complex(0, 0.5) * (d - m);
    out.slope(i, 0) = 0.5 * (d1 + m1);
    out.slope(i, 1) = Complex(0, 0.5) * (d1 - m1);
  }
  return out;
}

}  // namespace percuss::identify
