#include "identify/decay/decay_spectra.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/units.hpp"

namespace percuss::identify {

namespace {

// exp(−jω_k) of the lines, per sample. A recurrence would lose digits of 1 − q near the resonance (decay_columns).
std::vector<Complex> phasors(std::size_t first, std::size_t count, std::size_t samples) {
  std::vector<Complex> out(count);
  for (std::size_t k = 0; k < count; ++k)
    out[k] = std::polar(1.0, -kTwoPi * static_cast<double>(first + k) / static_cast<double>(samples));
  return out;
}

// The phasors of lines first … first + count − 1.
class LinePhasors {
 public:
  LinePhasors(const DecaySpectra& spectra, std::size_t first, std::size_t count) {
    if (!spectra.phasors) own_ = phasors(first, count, spectra.samples);
    at_ = spectra.phasors ? spectra.phasors->data() + first : own_.data();
  }
  const Complex& operator[](Eigen::Index i) const { return at_[i]; }

 private:
  std::vector<Complex> own_;
  const Complex* at_ = nullptr;
};

// 1/z by division: core's inverse() rounds once more.
Complex divided_inverse(const Complex& z) { return std::conj(z) / std::norm(z); }

}  // namespace

DecaySpectra decay_spectra(const FreeDecays& decays) {
  DecaySpectra out{
      .fs_Hz = decays.fs_Hz,
      .samples = decays.samples(),
      .hits = decays.hits,
      .channels = decays.channels,
      .lines = {},
      .phasors = std::make_shared<const std::vector<Complex>>(phasors(0, decays.samples() / 2 + 1, decays.samples()))};
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

bool overlap(const DecayRate& a, const DecayRate& b, double bandwidths, double margin_Hz) {
  const Complex s = a.rate_radps, t = b.rate_radps;
  return std::abs(s.imag() - t.imag()) < -bandwidths * (s.real() + t.real()) + kTwoPi * margin_Hz;
}

DecayRate decay_rate_of(const Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  return {omega * Complex(-zeta, std::sqrt(std::max(0.0, 1 - zeta * zeta)))};
}

Eigen::MatrixX2cd decay_values(const DecayRate& rate, const DecaySpectra& spectra, std::size_t first,
                               std::size_t count) {
  const LinePhasors phasor(spectra, first, count);
  Eigen::MatrixX2cd out(static_cast<Eigen::Index>(count), 2);
  const Complex s = rate.rate_radps / spectra.fs_Hz, step = std::exp(s);
  const Complex gone = 1.0 - std::exp(static_cast<double>(spectra.samples) * s);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const Complex q = phasor[i];
    const Complex d = gone * divided_inverse(1.0 - step * q),
                  m = std::conj(gone) * divided_inverse(1.0 - std::conj(step) * q);
    out(i, 0) = 0.5 * (d + m);
    out(i, 1) = Complex(0, 0.5) * (d - m);
  }
  return out;
}

DecayColumns decay_columns(const DecayRate& rate, const DecaySpectra& spectra, std::size_t first, std::size_t count) {
  const LinePhasors phasor(spectra, first, count);
  const double dt_s = 1 / spectra.fs_Hz, n = static_cast<double>(spectra.samples);
  const auto rows = static_cast<Eigen::Index>(count);
  DecayColumns out{.value = Eigen::MatrixX2cd(rows, 2), .slope = Eigen::MatrixX2cd(rows, 2)};
  const Complex s = rate.rate_radps * dt_s, at_end = std::exp(n * s), step = std::exp(s);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto kernel = [&](Complex one_step, Complex z_n) {
      const Complex q = one_step * phasor[i], r = divided_inverse(1.0 - q), value = (1.0 - z_n) * r;
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
