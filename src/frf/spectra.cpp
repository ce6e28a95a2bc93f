#include "frf/spectra.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel/per_thread.hpp"
#include "frf/pulse_spectrum.hpp"
#include "frf/windows.hpp"

namespace percuss::frf {
namespace {

void transform(std::span<const double> x, const LineRange& lines, std::span<Complex> out) {
  const auto wanted = real_dft_in_scratch(x).subspan(lines.first, lines.count);
  std::copy(wanted.begin(), wanted.end(), out.begin());
}

double origin_of(const acquire::Hit& hit) { return static_cast<double>(hit.peak - hit.first); }

}  // namespace

LineRange lines_in_band(double fs_Hz, std::size_t samples, double low_Hz, double high_Hz) {
  LineRange lines{.fs_Hz = fs_Hz, .samples = samples};
  // A line within a millionth of the line spacing of an edge is inside the band: users type edges as round numbers.
  const double edge = 1e-6;
  const std::size_t last = samples / 2;
  const auto top = static_cast<double>(last);
  const double low = std::clamp(std::ceil(low_Hz / lines.df_Hz() - edge), 0.0, top + 1);
  const double high = std::clamp(std::floor(high_Hz / lines.df_Hz() + edge), 0.0, top);
  lines.first = static_cast<std::size_t>(low);
  lines.count = high >= low ? static_cast<std::size_t>(high - low) + 1 : 0;
  return lines;
}

ForceBlock force_block(const acquire::Hit& hit, double fs_Hz, double decay_per_s) {
  ForceBlock block{.offset = hit.gate_first - hit.first,
                   .force_N = hit.gated_N,
                   .ungated_N = hit.ungated_N,
                   .decay_per_s = decay_per_s};
  apply_exponential(block.ungated_N, decay_per_s, fs_Hz, origin_of(hit));
  apply_exponential(block.force_N, decay_per_s, fs_Hz, origin_of(hit) - static_cast<double>(block.offset));
  return block;
}

void force_spectrum(const ForceBlock& block, const LineRange& lines, std::span<Complex> out) {
  const bool short_pulse = block.ungated_N.empty() && block.offset + block.force_N.size() <= lines.samples;
  if (short_pulse && pulse_spectrum(block.force_N, block.offset, lines, out)) return;
  static const PerThread<std::vector<double>> blocks;
  std::vector<double>& x = blocks.local();  // zero between calls, so only the pulse is copied and cleared
  if (x.size() != lines.samples) x.assign(lines.samples, 0);
  const std::vector<double>& force = block.ungated_N.empty() ? block.force_N : block.ungated_N;
  const std::size_t offset = block.ungated_N.empty() ? std::min(block.offset, x.size()) : 0;
  const auto pulse = std::span(x).subspan(offset, std::min(force.size(), x.size() - offset));
  std::copy_n(force.begin(), pulse.size(), pulse.begin());
  transform(x, lines, out);
  std::fill(pulse.begin(), pulse.end(), 0.0);
}

std::vector<Complex> force_spectrum(const ForceBlock& block, const LineRange& lines) {
  std::vector<Complex> spectrum(lines.count);
  force_spectrum(block, lines, spectrum);
  return spectrum;
}

void accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                    double decay_per_s, std::span<Complex> out) {
  assert(accel_mps2.size() >= lines.samples);
  const auto block = accel_mps2.first(lines.samples);
  if (decay_per_s == 0) {
    transform(block, lines, out);
    return;
  }
  std::vector<double> x(block.begin(), block.end());
  apply_exponential(x, decay_per_s, lines.fs_Hz, origin_of(hit));
  transform(x, lines, out);
}

std::vector<Complex> accel_spectrum(const acquire::Hit& hit, std::span<const double> accel_mps2, const LineRange& lines,
                                    double decay_per_s) {
  std::vector<Complex> spectrum(lines.count);
  accel_spectrum(hit, accel_mps2, lines, decay_per_s, spectrum);
  return spectrum;
}

}  // namespace percuss::frf
