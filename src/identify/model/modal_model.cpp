#include "identify/model/modal_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math/complex.hpp"
#include "core/math/tall_products.hpp"
#include "core/math/wide_loops.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

constexpr double kNegligibleAmplitude =
    1e-10;  // the neglected truncation moves a pole by at most this fraction of its bandwidth, below any noise

Eigen::Map<const Eigen::ArrayXcd> array_of(std::span<const Complex> lines) {
  return {lines.data(), static_cast<Eigen::Index>(lines.size())};
}

struct PoleTerms {
  double omega, zeta;
  Complex s, by_omega, by_zeta;  // s and its derivatives
};

PoleTerms terms_of(const Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz;
  const double zeta = pole.damping_ratio;
  const double root = std::sqrt(1 - zeta * zeta);
  const Complex direction(-zeta, root);
  return {.omega = omega,
          .zeta = zeta,
          .s = omega * direction,
          .by_omega = direction,
          .by_zeta = omega * Complex(-1, -zeta / root)};
}

// q_h and dq_h/ds of (1).
std::pair<Complex, Complex> state_at_end(const frf::ForceBlock& block, Complex s, double dt_s, std::size_t samples) {
  Complex q, by_s;
  const Complex step = std::exp(-s * dt_s);
  Complex decay = std::exp(s * (static_cast<double>(samples - block.offset) * dt_s));
  for (std::size_t n = 0; n < block.force_N.size() && block.offset + n < samples; ++n) {
    const Complex term = dt_s * block.force_N[n] * decay;
    q += term;
    by_s += term * (static_cast<double>(samples - block.offset - n) * dt_s);
    decay *= step;
  }
  return {q, by_s};
}

// The truncation term of one of the two conjugate poles.
struct TruncationTerm {
  Complex windowed;                // s − σ
  Complex c, c_by_s;               // at constant ω_d; see subtract_truncation_term
  std::vector<Complex> q, q_by_s;  // [hits]
};

TruncationTerm truncation_term_of(Complex s, const PointForce& force, const acquire::LineRange& lines) {
  const Complex two_j_wd(0, 2 * s.imag());  // s.imag() = ±ω_d: the conjugate pole has the conjugate factor
  TruncationTerm m{.windowed = s - force.window_decay_per_s(),
                   .c = s * s / two_j_wd,
                   .c_by_s = 2.0 * s / two_j_wd,
                   .q = {},
                   .q_by_s = {}};
  for (const frf::ForceBlock& block : force.blocks) {
    const auto [q, by_s] = state_at_end(block, m.windowed, 1 / lines.fs_Hz, lines.samples);
    m.q.push_back(q);
    m.q_by_s.push_back(by_s);
  }
  return m;
}

// Subtracts the term from the column's value and, by the chain rule along ds, from its derivatives.
void subtract_truncation_term(ModeColumn& column, const PoleTerms& p, bool conjugate, const PointForce& force,
                              const acquire::LineRange& lines, std::size_t first) {
  const double dt_s = 1 / lines.fs_Hz;
  const auto side = [&](Complex z) { return conjugate ? std::conj(z) : z; };
  const TruncationTerm m = truncation_term_of(side(p.s), force, lines);
  // c contains 1/ω_d: d(1/ω_d) = −dω_d/ω_d · (1/ω_d).
  const Complex by_freq = side(p.by_omega) * kTwoPi;
  const Complex by_damping = side(p.by_zeta);
  const double wd_by_freq = p.by_omega.imag() * kTwoPi / p.s.imag();
  const double wd_by_damping = p.by_zeta.imag() / p.s.imag();
  const Complex decay = std::exp(m.windowed * dt_s);
  const Complex step = std::polar(1.0, -kTwoPi * lines.df_Hz() * dt_s);
  Complex turn = std::polar(1.0, -kTwoPi * lines.freq_Hz(first) * dt_s);
  for (Eigen::Index i = 0; i < column.value.size(); ++i, turn = times(turn, step)) {
    const std::size_t line = first + static_cast<std::size_t>(i);
    Complex q, q_by_s;
    for (std::size_t h = 0; h < m.q.size(); ++h) {
      const Complex weight = std::conj(force.spectra[h].get()[line]) / force.ff[line];
      q += times(weight, m.q[h]);
      q_by_s += times(weight, m.q_by_s[h]);
    }
    const Complex around = times(decay, turn);
    const Complex d = inverse(1.0 - around);
    const Complex value = times(m.c, times(q, d));
    column.value(i) -= value;
    const Complex d_by_s = dt_s * times(around, times(d, d));
    const Complex by_s = times(m.c_by_s, times(q, d)) + times(m.c, times(q_by_s, d) + times(q, d_by_s));
    column.by_freq(i) -= times(by_s, by_freq) - value * wd_by_freq;
    column.by_damping(i) -= times(by_s, by_damping) - value * wd_by_damping;
  }
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

// The truncation of a mode at the lines from `first` on, but for the force: the factors of its two conjugate poles.
struct DecayColumn {
  std::size_t first;
  const Complex *kernel, *mirror;
};

// Adds the missing decay of a mode with this residue. q: [hits] the state of the mode at the end of the record.
PERCUSS_WIDE_LOOPS void add_decay(std::span<Complex> sum, Complex residue, const PointForce& force,
                                  const std::vector<Complex>& q, const DecayColumn& column) {
  // Hits outside, lines inside: the compiler then takes several lines at a time.
  constexpr std::size_t kBlock = 128;
  std::array<double, kBlock> rr{}, ii{}, ri{}, ir{};
  for (std::size_t begin = 0; begin < sum.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, sum.size() - begin);
    // conj(F)·q and conj(F)·conj(q) share their products.
    const Complex* first = force.spectra[0].get() + column.first + begin;
    for (std::size_t i = 0; i < count; ++i) {
      rr[i] = first[i].real() * q[0].real();
      ii[i] = first[i].imag() * q[0].imag();
      ri[i] = first[i].real() * q[0].imag();
      ir[i] = first[i].imag() * q[0].real();
    }
    for (std::size_t h = 1; h < q.size(); ++h) {
      const Complex* f = force.spectra[h].get() + column.first + begin;
      for (std::size_t i = 0; i < count; ++i) {
        rr[i] += f[i].real() * q[h].real();
        ii[i] += f[i].imag() * q[h].imag();
        ri[i] += f[i].real() * q[h].imag();
        ir[i] += f[i].imag() * q[h].real();
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = begin + i;
      const Complex all = times(column.kernel[k], {rr[i] + ii[i], ri[i] - ir[i]}) +
                          times(column.mirror[k], {rr[i] - ii[i], -ri[i] - ir[i]});
      sum[k] += times(residue, all) * (1 / force.ff[column.first + k]);
    }
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
  constexpr std::size_t kBlock = 256;  // lines whose sum fits into the first-level cache
  for (std::size_t first = 0; first < frf.size(); first += kBlock) {
    const std::size_t end = std::min(first + kBlock, frf.size());
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
    TruncatedDecay(pole, force.window_decay_per_s(), lines, first, count)
        .add_to({whole.value.data(), count}, -1, force);
    return whole;
  }
  const PoleTerms terms = terms_of(pole);
  for (const bool conjugate : {false, true}) subtract_truncation_term(whole, terms, conjugate, force, lines, first);
  return whole;
}

TruncatedDecay::TruncatedDecay(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines,
                               std::size_t first, std::size_t count)
    : lines_(lines), first_(first), windowed_(terms_of(pole).s - window_decay_per_s), kernel_(count), mirror_(count) {
  const double dt_s = 1 / lines.fs_Hz;
  const Complex s = terms_of(pole).s;
  const Complex c = s * s / Complex(0, 2 * s.imag());
  const Complex decay = std::exp(windowed_ * dt_s);
  const Complex step = std::polar(1.0, -kTwoPi * lines.df_Hz() * dt_s);
  Complex turn = std::polar(1.0, -kTwoPi * lines.freq_Hz(first) * dt_s);
  for (std::size_t i = 0; i < count; ++i, turn = times(turn, step)) {
    kernel_[i] = times(c, inverse(1.0 - times(decay, turn)));
    mirror_[i] = conj_times(c, inverse(1.0 - conj_times(decay, turn)));
  }
}

void TruncatedDecay::add_to(std::span<Complex> sum, Complex residue, const PointForce& force) const {
  std::vector<Complex> q;
  for (const frf::ForceBlock& block : force.blocks)
    q.push_back(state_at_end(block, windowed_, 1 / lines_.fs_Hz, lines_.samples).first);
  add_decay(sum, residue, force, q, {.first = first_, .kernel = kernel_.data(), .mirror = mirror_.data()});
}

ModeValues::ModeValues(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines, std::size_t first,
                       std::size_t count)
    : pole_(pole),
      lines_(lines),
      whole_(untruncated_column(pole, window_decay_per_s, lines, first, count, ColumnContent::value).value) {
  if (remaining_amplitude(pole, lines, window_decay_per_s) >= kNegligibleAmplitude)
    missing_.emplace(pole, window_decay_per_s, lines, first, count);
}

void ModeValues::add_to(std::span<Complex> sum, Complex residue, const PointForce& force) const {
  add_scaled(sum.data(), residue, whole_.data(), sum.size());
  if (missing_ && !decays_within_record(pole_, force, lines_)) missing_->add_to(sum, -residue, force);
}

ModeColumn mode_column(const Pole& pole, const PointForce& force, const acquire::LineRange& lines, std::size_t first,
                       std::size_t count, ColumnContent need) {
  return subtract_truncation(untruncated_column(pole, force.window_decay_per_s(), lines, first, count, need), pole,
                             force, lines, first);
}

}  // namespace percuss::identify
