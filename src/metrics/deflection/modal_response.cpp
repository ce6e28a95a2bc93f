#include "metrics/deflection/modal_response.hpp"

#include <cmath>

#include "core/units.hpp"
#include "metrics/deflection/laplace_transform.hpp"

namespace percuss::metrics {
namespace {

Complex pole_of(const identify::Pole& pole) {
  const double omega = kTwoPi * pole.freq_Hz, zeta = pole.damping_ratio;
  return omega * Complex(-zeta, std::sqrt(1 - zeta * zeta));
}

Complex receptance(const identify::Pole& pole, Complex residue, Complex s) {
  const Complex p = pole_of(pole), a = residue / Complex(0, 2 * p.imag());
  return a / (s - p) + std::conj(a) / (s - std::conj(p));  // (1)
}

}  // namespace

ModalDeflection modal_deflection(std::span<const double> force_N, double fs_Hz,
                                 const std::vector<ModalContribution>& modes, double rigid_per_kg) {
  const LaplaceTransform force(force_N, fs_Hz);
  const auto total = [&](Complex s) {
    Complex sum = rigid_per_kg / (s * s);
    for (const ModalContribution& mode : modes) sum += receptance(mode.pole, mode.residue_per_kg, s);
    return sum;
  };
  ModalDeflection out{.accel_mps2 = force.response([&](Complex s) { return s * s * total(s); }),
                      .velocity_mps = force.response([&](Complex s) { return s * total(s); }),
                      .deflection_m = force.response(total),
                      .std_m = std::vector<double>(force_N.size())};
  for (const ModalContribution& mode : modes) {
    for (const Complex& unit : {Complex(1, 0), Complex(0, 1)}) {
      const auto share = force.response([&](Complex s) { return receptance(mode.pole, unit, s); });
      for (std::size_t i = 0; i < share.size(); ++i) out.std_m[i] += std::pow(share[i] * mode.residue_std_per_kg, 2);
    }
  }
  for (double& std : out.std_m) std = std::sqrt(std);
  return out;
}

}  // namespace percuss::metrics
