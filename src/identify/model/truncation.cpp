#include "identify/model/truncation.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include "core/math/complex.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

// c·D and its derivative by s at constant ω_d. around = exp((s − jω)Δ)
std::pair<Complex, Complex> factor_and_slope(Complex c, Complex c_by_s, Complex around, double dt_s) {
  const Complex d = inverse(1.0 - around);
  const Complex d_by_s = dt_s * times(around, times(d, d));
  return {times(c, d), times(c_by_s, d) + times(c, d_by_s)};
}

}  // namespace

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

Truncation::Truncation(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines)
    : lines_(lines), terms_(terms_of(pole)), windowed_(terms_.s - window_decay_per_s) {}

std::vector<Truncation::Factors> Truncation::factors(std::size_t first, std::size_t count) const {
  const double dt_s = 1 / lines_.fs_Hz;
  const Complex s = terms_.s;
  const Complex two_j_wd(0, 2 * s.imag());
  const Complex c = s * s / two_j_wd, c_by_s = 2.0 * s / two_j_wd;
  const Complex decay = std::exp(windowed_ * dt_s);
  const Complex step = std::polar(1.0, -kTwoPi * lines_.df_Hz() * dt_s);
  Complex turn = std::polar(1.0, -kTwoPi * lines_.freq_Hz(first) * dt_s);
  std::vector<Factors> out(count);
  for (Factors& of : out) {
    std::tie(of.value, of.by_s) = factor_and_slope(c, c_by_s, times(decay, turn), dt_s);
    std::tie(of.mirror, of.mirror_by_s) =
        factor_and_slope(std::conj(c), std::conj(c_by_s), conj_times(decay, turn), dt_s);
    turn = times(turn, step);
  }
  return out;
}

EndStates Truncation::end_states(const PointForce& force) const {
  EndStates states;
  const double dt_s = 1 / lines_.fs_Hz;
  const Complex step = std::exp(-windowed_ * dt_s);
  for (const frf::ForceBlock& block : force.blocks) {
    Complex q, by_s;
    Complex decay = std::exp(windowed_ * (static_cast<double>(lines_.samples - block.offset) * dt_s));
    for (std::size_t n = 0; n < block.force_N.size() && block.offset + n < lines_.samples; ++n) {
      const Complex term = dt_s * block.force_N[n] * decay;
      q += term;
      by_s += term * (static_cast<double>(lines_.samples - block.offset - n) * dt_s);
      decay = times(decay, step);
    }
    states.q.push_back(q);
    states.q_by_s.push_back(by_s);
  }
  return states;
}

void Truncation::subtract_from(ModeColumn& column, const std::vector<Factors>& factors, const PointForce& force,
                               std::size_t first) const {
  const EndStates states = end_states(force);
  const Complex by_freq = terms_.by_omega * kTwoPi, by_damping = terms_.by_zeta;
  // c contains 1/ω_d: d(1/ω_d) = −dω_d/ω_d · (1/ω_d).
  const double wd_by_freq = by_freq.imag() / terms_.s.imag(), wd_by_damping = by_damping.imag() / terms_.s.imag();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    Complex sum, sum_by_s, mirror, mirror_by_s;  // Σ conj(F)·q and, as the conjugate pole has conj(q), Σ conj(F·q)
    for (std::size_t h = 0; h < states.q.size(); ++h) {
      const Complex f = force.spectra[h].get()[first + i];
      sum += conj_times(f, states.q[h]);
      sum_by_s += conj_times(f, states.q_by_s[h]);
      mirror += std::conj(times(f, states.q[h]));
      mirror_by_s += std::conj(times(f, states.q_by_s[h]));
    }
    const double per_power = 1 / force.ff[first + i];
    const Factors& of = factors[i];
    const Complex value = (times(of.value, sum) + times(of.mirror, mirror)) * per_power;
    const Complex by_s = (times(of.by_s, sum) + times(of.value, sum_by_s)) * per_power;
    const Complex by_mirror = (times(of.mirror_by_s, mirror) + times(of.mirror, mirror_by_s)) * per_power;
    const auto k = static_cast<Eigen::Index>(i);
    column.value(k) -= value;
    column.by_freq(k) -= times(by_s, by_freq) + conj_times(by_freq, by_mirror) - value * wd_by_freq;
    column.by_damping(k) -= times(by_s, by_damping) + conj_times(by_damping, by_mirror) - value * wd_by_damping;
  }
}

}  // namespace percuss::identify
