#include "synth/pulse.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/budget.hpp"
#include "synth/anti_alias_filter.hpp"

namespace percuss::synth {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr double kDecayExponent = 42;  // a decay is truncated below e^−42 = 6e-19

// A term amplitude · e^{j m W t} of the pulse's shape, m = multiple, W = π/width. The list of terms also holds the
// conjugate of each term, so the shape is real.
struct Harmonic {
  double multiple;
  Complex amplitude;
};

std::vector<Harmonic> harmonics(PulseKind kind) {
  switch (kind) {
    case PulseKind::haversine:
      return {{0, 0.5}, {2, -0.25}, {-2, -0.25}};
    case PulseKind::sine_cubed:
      return {{1, {0, -0.375}}, {-1, {0, 0.375}}, {3, {0, 0.125}}, {-3, {0, -0.125}}};
    case PulseKind::halfsine:
      break;
  }
  return {{1, {0, -0.5}}, {-1, {0, 0.5}}};
}

double unit_pulse(PulseKind kind, double fraction) {
  if (fraction < 0 || fraction > 1) return 0;
  const double s = std::sin(kPi * fraction);
  return kind == PulseKind::halfsine ? s : kind == PulseKind::haversine ? s * s : s * s * s;
}

// (e^a − e^b)/(a − b), accurate also for a ≈ b.
Complex divided_exponential(Complex a, Complex b) {
  const Complex z = a - b;
  if (std::abs(z) > 0.5) return (std::exp(a) - std::exp(b)) / z;
  Complex sum = 0;
  for (int n = 18; n >= 1; --n) sum = (sum * z + 1.0) / static_cast<double>(n);
  return std::exp(b) * sum;
}

// The pole of a mode in 1/sample, and the factor c of the regular part 2 Re(c e^{λt}) of its acceleration.
struct SampledPole {
  Complex lambda, factor;
  SampledPole(const SynthPole& pole, double fs_Hz) {
    const double omega = 2 * kPi * pole.freq_Hz / fs_Hz;
    const double damped = omega * std::sqrt((1 - pole.damping_ratio) * (1 + pole.damping_ratio));
    lambda = {-pole.damping_ratio * omega, damped};
    factor = lambda * lambda / Complex(0, 2 * damped);
  }
};

// A pulse in samples, shape 1 at its peak.
struct SampledPulse {
  PulseKind kind;
  double onset, width, end;
  SampledPulse(const Pulse& pulse, double fs_Hz)
      : kind(pulse.kind), onset(pulse.onset_s * fs_Hz), width(pulse.width_s * fs_Hz), end(onset + width) {}

  // ∫_0^τ e^{λ(τ−v)} p(v) dv, 0 <= τ <= width.
  Complex response(Complex lambda, double tau) const {
    Complex sum = 0;
    for (const Harmonic& h : harmonics(kind)) {
      sum += h.amplitude * tau * divided_exponential({0, h.multiple * kPi * tau / width}, lambda * tau);
    }
    return sum;
  }
};

// The samples first <= n < last that depend on the pulse through the filter.
struct Zone {
  long first, last;
  explicit Zone(const SampledPulse& p)
      : first(static_cast<long>(std::floor(p.onset - kFilterHalfWidth))),
        last(static_cast<long>(std::ceil(p.end + kFilterHalfWidth)) + 1) {}
};

// The filtered force (unit peak) and, per pole, the filtered modal response during the pulse, for samples n in [a, b)
// of the zone.
struct DuringPulse {
  std::vector<double> force;
  std::vector<std::vector<Complex>> modal;
};

DuringPulse during_pulse(const SampledPulse& pulse, const std::vector<SampledPole>& poles, long a, long b) {
  const auto size = static_cast<std::size_t>(b - a);
  DuringPulse out{std::vector<double>(size), {poles.size(), std::vector<Complex>(size)}};
  const auto panels = static_cast<std::size_t>(std::ceil(pulse.width / 2));
  const double step = pulse.width / static_cast<double>(panels);
  std::vector<Complex> response(poles.size());
  for (std::size_t node = 0; node < panels * kGaussNodes; ++node) {
    check_budget();
    const std::size_t panel = node / kGaussNodes, in_panel = node % kGaussNodes;
    const double tau = (static_cast<double>(panel) + gauss_legendre().x[in_panel]) * step;
    const double weight = gauss_legendre().weight[in_panel] * step;
    const double shape = unit_pulse(pulse.kind, tau / pulse.width);
    for (std::size_t r = 0; r < poles.size(); ++r) response[r] = pulse.response(poles[r].lambda, tau);
    for (std::size_t i = 0; i < size; ++i) {
      const double kernel =
          weight * anti_alias_kernel(static_cast<double>(a) + static_cast<double>(i) - pulse.onset - tau);
      out.force[i] += kernel * shape;
      for (std::size_t r = 0; r < poles.size(); ++r) out.modal[r][i] += kernel * response[r];
    }
  }
  return out;
}

// Z[i] = ∫_{−w}^{v} b(u) e^{λ(v−u)} du at v = zone.first + i − end: the filtered decay that starts at the end of the
// pulse. b is anti_alias_kernel, w is kFilterHalfWidth. There is one panel per sample. The recursion Z(v + 1) = e^λ
// Z(v) + new panel damps its own rounding errors.
std::vector<std::vector<Complex>> after_pulse(const SampledPulse& pulse, const std::vector<SampledPole>& poles,
                                              const Zone& zone) {
  const auto size = static_cast<std::size_t>(zone.last - zone.first);
  std::vector<std::vector<Complex>> out(poles.size(), std::vector<Complex>(size));
  const auto v_of = [&](std::size_t i) { return static_cast<double>(zone.first) + static_cast<double>(i) - pulse.end; };
  // A panel spans [from, from + width]: one sample, or less where the filter begins and ends.
  const auto from_of = [&](std::size_t i) { return std::max(v_of(i) - 1, -kFilterHalfWidth); };
  const auto width_of = [&](std::size_t i) { return std::max(0.0, std::min(v_of(i), kFilterHalfWidth) - from_of(i)); };
  std::vector<std::array<double, kGaussNodes>> kernel(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < kGaussNodes; ++k) {
      kernel[i][k] = gauss_legendre().weight[k] * width_of(i) *
                     anti_alias_kernel(from_of(i) + gauss_legendre().x[k] * width_of(i));
    }
  }
  for (std::size_t r = 0; r < poles.size(); ++r) {
    check_budget();
    const Complex step = std::exp(poles[r].lambda);
    std::array<Complex, kGaussNodes> decay;  // from the nodes of a panel to its v; the same in all full panels
    double decay_width = -1;
    Complex z = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double width = width_of(i), gap = v_of(i) - from_of(i) - width;
      if (width != decay_width || gap != 0) {
        for (std::size_t k = 0; k < kGaussNodes; ++k)
          decay[k] = std::exp(poles[r].lambda * (v_of(i) - from_of(i) - gauss_legendre().x[k] * width));
        decay_width = gap == 0 ? width : -1;
      }
      z *= step;
      for (std::size_t k = 0; k < kGaussNodes && width > 0; ++k) z += kernel[i][k] * decay[k];
      out[r][i] = z;
    }
  }
  return out;
}

// Appends Re(start·e^{λ n}) for n = skip, skip + 1, … until it falls below e^−42 of the peak, at most `most` values.
// Each value is a product of two exponentials, so errors do not grow with n.
void append_decay(Complex start, Complex lambda, double skip, double peak, double most, std::vector<double>& to) {
  const double size = std::log(std::abs(start) / (std::abs(peak) + 1e-300) + 1e-300) + kDecayExponent;
  const auto count = static_cast<std::size_t>(std::clamp(std::ceil(size / -lambda.real() - skip), 0.0, most));
  constexpr std::size_t kBlock = 256;
  std::array<Complex, kBlock> powers;
  for (std::size_t i = 0; i < std::min(kBlock, count); ++i) powers[i] = std::exp(lambda * static_cast<double>(i));
  to.reserve(to.size() + count);
  for (std::size_t block = 0; block < count; block += kBlock) {
    const Complex head = start * std::exp(lambda * (skip + static_cast<double>(block)));
    for (std::size_t i = 0; i < std::min(kBlock, count - block); ++i) {
      to.push_back(head.real() * powers[i].real() - head.imag() * powers[i].imag());
    }
  }
}

}  // namespace

double pulse_force_N(const Pulse& pulse, double t_s) {
  return pulse.peak_N * unit_pulse(pulse.kind, t_s / pulse.width_s);
}

PulseSupport pulse_support(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles) {
  constexpr double kMaxGrowthExponent = 5;  // a regular part never exceeds e^5 times the peak of the force
  const Zone zone(SampledPulse(pulse, fs_Hz));
  double longest = 0;
  for (const SynthPole& pole : poles) {
    longest = std::max(longest,
                       (kDecayExponent + kMaxGrowthExponent) * fs_Hz / (2 * kPi * pole.freq_Hz * pole.damping_ratio));
  }
  return {static_cast<double>(zone.first), static_cast<double>(zone.last) + longest};
}

PulseBasis pulse_basis(const Pulse& pulse, double fs_Hz, std::span<const SynthPole> poles, std::size_t first,
                       std::size_t count) {
  assert(pulse.width_s > 0 && fs_Hz > 0);
  const SampledPulse sampled(pulse, fs_Hz);
  std::vector<SampledPole> sampled_poles;
  for (const SynthPole& pole : poles) sampled_poles.emplace_back(pole, fs_Hz);
  const Zone zone(sampled);
  const auto range_first = static_cast<long>(first), range_last = static_cast<long>(first + count);
  const long a = std::clamp(zone.first, range_first, range_last);
  const long b = std::clamp(zone.last, a, range_last);
  PulseBasis out{static_cast<std::size_t>(a), {}, std::vector<std::vector<double>>(sampled_poles.size())};
  DuringPulse during = during_pulse(sampled, sampled_poles, a, b);
  out.force_N = std::move(during.force);
  for (double& f : out.force_N) f *= pulse.peak_N;
  const auto after = after_pulse(sampled, sampled_poles, zone);
  for (std::size_t r = 0; r < sampled_poles.size(); ++r) {
    check_budget();
    const Complex at_end = sampled.response(sampled_poles[r].lambda, sampled.width);
    const Complex scale = 2 * pulse.peak_N * sampled_poles[r].factor;
    for (std::size_t i = 0; i < out.force_N.size(); ++i) {
      const Complex filtered_decay = after[r][static_cast<std::size_t>(a - zone.first) + i] * at_end;
      out.regular_N[r].push_back((scale * (during.modal[r][i] + filtered_decay)).real());
    }
    // From the last sample of the zone on the response is a pure exponential.
    const auto skip = static_cast<double>(b - (zone.last - 1));
    append_decay(scale * after[r].back() * at_end, sampled_poles[r].lambda, skip, pulse.peak_N,
                 static_cast<double>(range_last - b), out.regular_N[r]);
  }
  return out;
}

}  // namespace percuss::synth
