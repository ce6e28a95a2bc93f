#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"

namespace percuss::frf {

/// The lines of a transform of `samples` values that are kept: first … first + count − 1.
struct LineRange {
  double fs_Hz = 0;
  std::size_t samples = 0;
  std::size_t first = 0;
  std::size_t count = 0;
  double df_Hz() const { return fs_Hz / static_cast<double>(samples); }
  double freq_Hz(std::size_t line) const { return static_cast<double>(first + line) * df_Hz(); }
  double position(double freq_Hz) const { return freq_Hz / df_Hz() - static_cast<double>(first); }  // in lines
  std::size_t nearest(double freq_Hz) const { return at(position(freq_Hz)); }
  /// The line nearest to a position; the first or last one for a position beyond them.
  std::size_t at(double position) const {
    return static_cast<std::size_t>(std::clamp(std::round(position), 0.0, static_cast<double>(count - 1)));
  }
};

/// The lines of a transform that lie within [low, high] Hz.
LineRange lines_in_band(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz);

/// A hit's force as it enters the spectra, in a block that begins at the hit's first sample: the pulse, or everything
/// when it is not gated. With an exponential window it carries that window; `decay_per_s` is 0 without one.
struct ForceBlock {
  std::size_t offset = 0;         // of the pulse's first sample within the block
  std::vector<double> force_N;    // the pulse: what drives the structure
  std::vector<double> ungated_N;  // from the block's beginning; empty: the force is zero outside the pulse
  double decay_per_s = 0;
};
ForceBlock force_block(const acquire::Hit& hit, double fs_Hz, double decay_per_s);

/// The first line of a transform that several hold at once. shape  [lines]
using Spectrum = std::shared_ptr<const Complex>;
inline Spectrum shared(std::vector<Complex> lines) {
  const auto owner = std::make_shared<const std::vector<Complex>>(std::move(lines));
  return {owner, owner->data()};
}

/// Transform of a force block at the lines wanted. One real FFT. shapes: out [lines.count]; units N (unscaled sums).
void force_spectrum(const ForceBlock& block, const LineRange& lines, std::span<Complex> out);
std::vector<Complex> force_spectrum(const ForceBlock& block, const LineRange& lines);

/// Transform of one acceleration channel over the hit's stretch (cut to lines.samples); the window has its origin at
/// the pulse's peak as for the force. `accel_mps2` holds at least lines.samples values, `out` lines.count.
void accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                    double decay_per_s, std::span<Complex> out);
std::vector<Complex> accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                                    double decay_per_s);

}  // namespace percuss::frf
