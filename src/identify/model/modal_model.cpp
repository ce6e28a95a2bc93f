#include "identify/model/modal_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/complex.hpp"
#include "core/units.hpp"
#include "identify/model/point_columns.hpp"
#include "identify/model/truncation.hpp"

namespace percuss::identify {
namespace {

// The neglected truncation moves a pole by at most this fraction of its bandwidth, which is below any noise.
constexpr double kNegligibleAmplitude = 1e-10;

Eigen::Map<const Eigen::ArrayXcd> array_of(std::span<const Complex> lines) {
  return {lines.data(), static_cast<Eigen::Index>(lines.size())};
}

// H and its derivatives on the imaginary axis, where (jω)² is real: a third of the work.
void fill_untruncated(ModeColumn& column, const PoleTerms& p, const acquire::LineRange& lines, std::size_t first) {
  const bool slopes = column.by_freq.size() > 0;
  const double step = kTwoPi * lines.df_Hz();
  for (Eigen::Index i = 0; i < column.value.size(); ++i) {
    const double omega = step * static_cast<double>(lines.first + first + static_cast<std::size_t>(i));
    const double w2 = omega * omega;
    const double re = p.omega * p.omega - w2;
    const double im = 2 * p.zeta * p.omega * omega;
    const double share = 1 / (re * re + im * im);
    const Complex resonance(re * share, -im * share);
    column.value(i) = -w2 * resonance;
    if (!slopes) continue;
    const Complex slope = w2 * times(resonance, resonance);
    column.by_freq(i) = times(slope, {2 * kTwoPi * p.omega, 2 * kTwoPi * p.zeta * omega});
    column.by_damping(i) = times(slope, {0, 2 * p.omega * omega});
  }
}

}  // namespace

PointForce point_force(std::vector<frf::ForceBlock> blocks, std::vector<frf::Spectrum> spectra,
                       const acquire::LineRange& lines, double noise_N) {
  PointForce force{.blocks = std::move(blocks),
                   .spectra = std::move(spectra),
                   .ff = std::vector<double>(lines.count),
                   .noise_N = noise_N};
  Eigen::Map<Eigen::ArrayXd> ff(force.ff.data(), static_cast<Eigen::Index>(lines.count));
  for (const frf::Spectrum& spectrum : force.spectra) ff += array_of({spectrum.get(), lines.count}).abs2();
  frf::require_force(force.ff, lines);
  return force;
}

std::vector<Complex> h1_at(const PointForce& force, std::span<const std::span<const Complex>> accel) {
  std::vector<Complex> frf(force.ff.size());
  for (std::size_t first = 0; first < frf.size(); first += frf::kLinesPerBlock) {
    const std::size_t end = std::min(first + frf::kLinesPerBlock, frf.size());
    for (std::size_t h = 0; h < accel.size(); ++h) {
      const Complex* f = force.spectra[h].get();
      const Complex* a = accel[h].data();
      for (std::size_t k = first; k < end; ++k) frf[k] += conj_times(f[k], a[k]);
    }
    for (std::size_t k = first; k < end; ++k) frf[k] /= force.ff[k];
  }
  return frf;
}

double remaining_amplitude(const Pole& pole, const acquire::LineRange& lines, double window_decay_per_s) {
  return std::exp(-(pole.damping_ratio * kTwoPi * pole.freq_Hz + window_decay_per_s) / lines.df_Hz());
}

bool decays_within_record(const Pole& pole, const PointForce& force, const acquire::LineRange& lines) {
  if (force.complete) return true;
  const bool known = std::any_of(force.blocks.begin(), force.blocks.end(),
                                 [](const frf::ForceBlock& block) { return !block.force_N.empty(); });
  if (!known) return true;  // without the force the truncation is unknown
  return remaining_amplitude(pole, lines, force.window_decay_per_s()) < kNegligibleAmplitude;
}

ModeColumn untruncated_column(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines,
                              std::size_t first, std::size_t count, ColumnContent need) {
  const PoleTerms p = terms_of(pole);
  const auto size = static_cast<Eigen::Index>(count);
  const bool slopes = need == ColumnContent::derivatives;
  ModeColumn column{Eigen::VectorXcd(size), Eigen::VectorXcd(slopes ? size : 0), Eigen::VectorXcd(slopes ? size : 0)};
  if (window_decay_per_s == 0) {
    fill_untruncated(column, p, lines, first);
    return column;
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    const Complex jw(window_decay_per_s, kTwoPi * lines.freq_Hz(first + static_cast<std::size_t>(i)));
    const Complex jw2 = times(jw, jw);
    const Complex resonance = inverse(jw2 + 2 * p.zeta * p.omega * jw + p.omega * p.omega);
    const Complex h = times(jw2, resonance);
    column.value(i) = h;
    if (!slopes) continue;
    const Complex slope = -times(h, resonance);
    column.by_freq(i) = times(slope, 2 * p.zeta * jw + 2 * p.omega) * kTwoPi;
    column.by_damping(i) = times(slope, 2 * p.omega * jw);
  }
  return column;
}

ModeColumn subtract_truncation(ModeColumn whole, const Pole& pole, const PointForce& force,
                               const acquire::LineRange& lines, std::size_t first) {
  if (decays_within_record(pole, force, lines)) return whole;
  const auto count = static_cast<std::size_t>(whole.value.size());
  if (whole.by_freq.size() == 0) {
    const std::vector<Complex> missing =
        TruncatedDecay(pole, force.window_decay_per_s(), lines, first, count).at(force);
    whole.value -= Eigen::Map<const Eigen::VectorXcd>(missing.data(), whole.value.size());
    return whole;
  }
  const Truncation truncation(pole, force.window_decay_per_s(), lines);
  truncation.subtract_from(whole, truncation.factors(first, count), force, first);
  return whole;
}

ModeColumn mode_column(const Pole& pole, const PointForce& force, const acquire::LineRange& lines, std::size_t first,
                       std::size_t count, ColumnContent need) {
  return subtract_truncation(untruncated_column(pole, force.window_decay_per_s(), lines, first, count, need), pole,
                             force, lines, first);
}

}  // namespace percuss::identify
