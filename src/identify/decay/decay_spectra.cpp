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
  const Complex j(0, 1);
  const Complex s = rate.rate_radps * dt_s, end = std::exp(n * s), left = 1.0 - end;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double w = kTwoPi * static_cast<double>(first + static_cast<std::size_t>(i)) / n;
    const auto kernel = [&](Complex exponent, Complex z_n, Complex one_minus) {
      const Complex q = std::exp(exponent - Complex(0, w)), r = 1.0 / (1.0 - q);
      return std::pair(one_minus * r, dt_s * r * (one_minus * q * r - n * z_n));
    };
    const auto [d, d1] = kernel(s, end, left);
    const auto [m, m1] = kernel(std::conj(s), std::conj(end), std::conj(left));
    out.value(i, 0) = 0.5 * (d + m);
    out.value(i, 1) = 0.5 * j * (d - m);
    out.slope(i, 0) = 0.5 * (d1 + m1);
    out.slope(i, 1) = 0.5 * j * (d1 - m1);
  }
  return out;
}

}  // namespace percuss::identify
