#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "acquire/record/line_range.hpp"
#include "acquire/record/record.hpp"
#include "core/math/fft.hpp"

namespace percuss::frf {

using acquire::LineRange;

/// The spectral lines within [low, high] Hz.
LineRange lines_in_band(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz);

/// The force of a hit for its spectrum, in a block that begins at the hit's first sample: the gated pulse, or the whole
/// force where it is not gated. The exponential window is applied; `decay_per_s` is 0 without one.
struct ForceBlock {
  std::size_t offset = 0;         // first sample of the pulse within the block
  std::vector<double> force_N;    // the pulse that drives the structure
  std::vector<double> ungated_N;  // the whole block; empty where the force is zero outside the pulse
  double decay_per_s = 0;
};
ForceBlock force_block(const acquire::Hit& hit, double fs_Hz, double decay_per_s);

/// A shared spectrum: a pointer to its first spectral line. shape  [lines]
using Spectrum = std::shared_ptr<const Complex>;

/// The spectrum of a force block: by pulse_spectrum for a short pulse, otherwise by one real FFT. shape  out
/// [lines.count]. units  N (unscaled sums).
void force_spectrum(const ForceBlock& block, const LineRange& lines, std::span<Complex> out);
std::vector<Complex> force_spectrum(const ForceBlock& block, const LineRange& lines);

/// The spectrum of one acceleration channel over the first lines.samples values of the hit. The exponential window is 1
/// at the peak of the pulse, as for the force. shapes  accel_mps2 at least [lines.samples]; out [lines.count].
void accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                    double decay_per_s, std::span<Complex> out);
std::vector<Complex> accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                                    double decay_per_s);

}  // namespace percuss::frf
