#pragma once
#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/math/complex.hpp"
#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// Responses of a structure that moves freely: no force acts from the first sample on.
struct FreeDecays {
  double fs_Hz = 0;
  std::size_t hits = 0, channels = 0;
  std::vector<std::vector<double>> response;  // [hits × channels], hit by hit, of equal length

  std::size_t samples() const { return response.empty() ? 0 : response.front().size(); }
};

/// The decays' spectra: one-sided, unscaled, without a window.
struct DecaySpectra {
  double fs_Hz = 0;
  std::size_t samples = 0, hits = 0, channels = 0;
  Eigen::MatrixXcd lines;  // [samples/2 + 1, hits × channels]
  // exp(−jω_kΔ) of the lines, shared by copies; computed where they are needed if null.
  std::shared_ptr<const std::vector<Complex>> phasors{};

  double df_Hz() const { return fs_Hz / static_cast<double>(samples); }
};
DecaySpectra decay_spectra(const FreeDecays& decays);

/// The complex rate s of a decaying oscillation. With the conjugate rate it gives the real response Re(a exp(st)).
struct DecayRate {
  Complex rate_radps;  // negative real part, positive imaginary part
  Pole pole() const;
};
DecayRate decay_rate_of(const Pole& pole);
/// Whether two decays overlap: their frequencies are nearer than `bandwidths` times the mean of their half-power
/// bandwidths, plus `margin_Hz`.
bool overlap(const DecayRate& a, const DecayRate& b, double bandwidths = 1, double margin_Hz = 0);

/// The spectra of Re(exp(st)) and Re(j exp(st)), and their derivatives by s, at lines first … first + count − 1. With
/// z = exp(sΔ), N samples and D(k) = (1 − z^N)/(1 − z exp(−jω_kΔ)), the exact transform of the truncated decay:
///   c₁ = (D + D̃)/2,  c₂ = j(D − D̃)/2,  D̃ the same with conj(s)                        (1)
/// shapes [count, 2].
/// theory (4.22), (4.23)
struct DecayColumns {
  Eigen::MatrixX2cd value, slope;  // slope: the columns (1) of t·exp(st)
};
DecayColumns decay_columns(const DecayRate& rate, const DecaySpectra& spectra, std::size_t first, std::size_t count);
/// Callers compute the columns for this many lines at a time, so that they stay in the cache.
constexpr std::size_t kDecayBlock_lines = 256;
/// Only the values of decay_columns.
Eigen::MatrixX2cd decay_values(const DecayRate& rate, const DecaySpectra& spectra, std::size_t first,
                               std::size_t count);

}  // namespace percuss::identify
