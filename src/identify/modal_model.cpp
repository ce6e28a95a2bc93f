#include "identify/modal_model.hpp"

#include <cmath>
#include <utility>

#include "core/units.hpp"

namespace percuss {
namespace {

constexpr double kGone = 1e-15;  // what has decayed to this fraction is not worth a transform's rounding

struct PoleTerms {
  double omega, zeta;
  Complex s, by_omega, by_zeta;  // s and its derivatives
};

PoleTerms terms_of(const Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz;
  const double zeta = pole.damping_ratio;
  const double root = std::sqrt(1 - zeta * zeta);
  const Complex direction(-zeta, root);
  return {.omega = omega, .zeta = zeta, .s = omega * direction, .by_omega = direction, .by_zeta = omega * Complex(-1, -zeta / root)};
}

// q_h and dq_h/ds of (1).
std::pair<Complex, Complex> state_at_end(const ForceBlock& block, Complex s, double dt_s, std::size_t samples) {
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

// What the part of the decay beyond the record's end takes away, and its derivative by s, for one sign of the imaginary part.
struct Missing {
  Eigen::VectorXcd value, by_s;
};

Missing missing_decay(Complex s, double window_decay, const PointForce& force, const LineRange& lines, std::size_t first, std::size_t count) {
  const double dt_s = 1 / lines.fs_Hz;
  const Complex c = s * s / Complex(0, 2 * s.imag());  // s.imag() = ±ω_d: the conjugate pole gets the conjugate factor
  // ω_d depends on s through its imaginary part; along the pole's own path that derivative is added by the caller's chain rule.
  const Complex c_by_s = 2.0 * s / Complex(0, 2 * s.imag());
  Missing out{Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count)), Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count))};
  const Complex windowed = s - window_decay;
  std::vector<std::pair<Complex, Complex>> ends;
  for (const ForceBlock& block : force.blocks) ends.push_back(state_at_end(block, windowed, dt_s, lines.samples));
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t line = first + k;
    Complex q, q_by_s;
    for (std::size_t h = 0; h < ends.size(); ++h) {
      const Complex weight = std::conj(force.spectra[h][line]) / force.ff[line];
      q += weight * ends[h].first;
      q_by_s += weight * ends[h].second;
    }
    const Complex turn = std::exp((windowed - Complex(0, kTwoPi * lines.freq_Hz(line))) * dt_s);
    const Complex d = 1.0 / (1.0 - turn);
    const Complex d_by_s = dt_s * turn * d * d;
    const auto i = static_cast<Eigen::Index>(k);
    out.value(i) = c * q * d;
    out.by_s(i) = c_by_s * q * d + c * (q_by_s * d + q * d_by_s);
  }
  return out;
}

}  // namespace

PointForce point_force(std::vector<ForceBlock> blocks, const LineRange& lines, double noise_N) {
  PointForce force{.blocks = std::move(blocks), .spectra = {}, .ff = std::vector<double>(lines.count), .noise_N = noise_N};
  for (const ForceBlock& block : force.blocks) {
    force.spectra.push_back(force_spectrum(block, lines));
    for (std::size_t k = 0; k < lines.count; ++k) force.ff[k] += std::norm(force.spectra.back()[k]);
  }
  return force;
}

ModeColumn mode_column(const Pole& pole, const PointForce& force, const LineRange& lines, std::size_t first, std::size_t count) {
  const PoleTerms p = terms_of(pole);
  const double window_decay = force.blocks.empty() ? 0 : force.blocks.front().decay_per_s;
  const auto size = static_cast<Eigen::Index>(count);
  ModeColumn column{Eigen::VectorXcd(size), Eigen::VectorXcd(size), Eigen::VectorXcd(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    const Complex jw(window_decay, kTwoPi * lines.freq_Hz(first + static_cast<std::size_t>(i)));
    const Complex denominator = jw * jw + 2 * p.zeta * p.omega * jw + p.omega * p.omega;
    const Complex h = jw * jw / denominator;
    column.value(i) = h;
    column.by_freq(i) = -h / denominator * (2 * p.zeta * jw + 2 * p.omega) * kTwoPi;
    column.by_damping(i) = -h / denominator * (2 * p.omega * jw);
  }
  const double duration_s = static_cast<double>(lines.samples) / lines.fs_Hz;
  if (std::exp((p.s.real() - window_decay) * duration_s) < kGone) return column;
  for (const bool conjugate : {false, true}) {
    const Complex s = conjugate ? std::conj(p.s) : p.s;
    const Missing missing = missing_decay(s, window_decay, force, lines, first, count);
    // c holds ω_d itself: d(1/ω_d) = −dω_d/ω_d · (1/ω_d).
    const double wd = p.s.imag();
    const auto chain = [&](Complex ds) -> Eigen::VectorXcd {
      const Complex step = conjugate ? std::conj(ds) : ds;
      return missing.by_s * step - missing.value * (ds.imag() / wd);
    };
    column.value -= missing.value;
    column.by_freq -= chain(p.by_omega) * kTwoPi;
    column.by_damping -= chain(p.by_zeta);
  }
  return column;
}

}  // namespace percuss
