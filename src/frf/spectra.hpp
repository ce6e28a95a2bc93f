#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/line_range.hpp"
#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"

namespace percuss::frf {

using acquire::LineRange;

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
