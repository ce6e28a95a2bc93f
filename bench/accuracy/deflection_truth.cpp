#include "deflection_truth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/units.hpp"
#include "synth/anti_alias_filter.hpp"

namespace percuss::accuracy {
namespace {

constexpr int kPanels = 64;
constexpr double kGrid = 100;   // points per period of the highest mode
constexpr double kPeriods = 2;  // of the lowest mode: the largest deflection lies within the first

}  // namespace

TrueDeflection::TrueDeflection(const synth::Pulse& pulse, const std::vector<synth::SynthPole>& poles)
    : end_s_(pulse.onset_s + pulse.width_s) {
  const synth::GaussLegendre& rule = synth::gauss_legendre();
  const double panel_s = pulse.width_s / kPanels;
  for (const synth::SynthPole& pole : poles) {
    const double omega = kTwoPi * pole.freq_Hz;
    ModalState state{.decay_per_s = pole.damping_ratio * omega,
                     .omega_radps = omega * std::sqrt(1 - pole.damping_ratio * pole.damping_ratio)};
    const std::complex<double> s(-state.decay_per_s, state.omega_radps);
    std::complex<double> z = 0;
    for (int p = 0; p < kPanels; ++p) {
      for (std::size_t i = 0; i < synth::kGaussNodes; ++i) {
        const double t_s = (p + rule.x.at(i)) * panel_s;  // after the onset
        z += rule.weight.at(i) * panel_s * synth::pulse_force_N(pulse, t_s) * std::exp(s * (pulse.width_s - t_s));
      }
    }
    state.re = z.real();
    state.im = z.imag();
    states_.push_back(state);
  }
}

double TrueDeflection::at_m(double t_s, const std::vector<double>& residue_per_kg) const {
  double sum = 0;
  const double after_s = t_s - end_s_;
  for (std::size_t r = 0; r < states_.size(); ++r) {
    const ModalState& z = states_[r];
    const double angle = z.omega_radps * after_s;
    sum += residue_per_kg[r] / z.omega_radps * std::exp(-z.decay_per_s * after_s) *
           (z.re * std::sin(angle) + z.im * std::cos(angle));  // (1)
  }
  return sum;
}

TrueDeflection::Peak TrueDeflection::peak(const std::vector<double>& residue_per_kg) const {
  const auto [slow, fast] =
      std::minmax_element(states_.begin(), states_.end(),
                          [](const ModalState& a, const ModalState& b) { return a.omega_radps < b.omega_radps; });
  const double step_s = kTwoPi / fast->omega_radps / kGrid;
  const double last_s = end_s_ + kPeriods * kTwoPi / slow->omega_radps;
  Peak top;
  for (double t = end_s_; t < last_s; t += step_s) {
    const double value = at_m(t, residue_per_kg);
    if (std::abs(value) > std::abs(top.value_m)) top = {value, t};
  }
  // Refines the peak: moves it to the vertex of the parabola through three points, on finer and finer grids.
  for (double width_s = step_s; width_s > 1e-9; width_s /= 10) {
    const double a = at_m(top.time_s - width_s, residue_per_kg), b = top.value_m,
                 c = at_m(top.time_s + width_s, residue_per_kg);
    if (a - 2 * b + c == 0) break;
    const double t = top.time_s + width_s * std::clamp(0.5 * (a - c) / (a - 2 * b + c), -1.0, 1.0);
    const double value = at_m(t, residue_per_kg);
    if (std::abs(value) > std::abs(top.value_m)) top = {value, t};
  }
  return top;
}

}  // namespace percuss::accuracy
