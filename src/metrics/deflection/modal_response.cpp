#include "metrics/deflection/modal_response.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "identify/model/truncation.hpp"
#include "metrics/deflection/laplace_transform.hpp"

namespace percuss::metrics {
namespace {

Complex receptance(const identify::Pole& pole, Complex residue, Complex s) {
  const Complex p = identify::terms_of(pole).s, a = residue / Complex(0, 2 * p.imag());
  return a / (s - p) + std::conj(a) / (s - std::conj(p));  // (1)
}

// Adds σ² Σ h², the variance of the deflection by independent noise of the samples while the force acts; h is the
// response to one sample of 1 N.
void add_force_noise(std::span<const double> force_N, double fs_Hz, const std::function<Complex(Complex s)>& transfer,
                     double noise_N, std::vector<double>& variance) {
  const auto acts = [](double f) { return f != 0; };
  const auto first = static_cast<std::size_t>(std::find_if(force_N.begin(), force_N.end(), acts) - force_N.begin());
  if (first == force_N.size()) return;
  const auto last = force_N.size() - 1 -
                    static_cast<std::size_t>(std::find_if(force_N.rbegin(), force_N.rend(), acts) - force_N.rbegin());
  std::vector<double> sample(force_N.size());
  sample.front() = 1;
  std::vector<double> sums{0};  // of h²
  for (const double h : LaplaceTransform(sample, fs_Hz).response(transfer)) sums.push_back(sums.back() + h * h);
  for (std::size_t i = first; i < variance.size(); ++i)
    variance[i] += noise_N * noise_N * (sums[i - first + 1] - sums[i - std::min(i, last)]);
}

}  // namespace

ModalDeflection modal_deflection(std::span<const double> force_N, double fs_Hz,
                                 const std::vector<ModalContribution>& modes, double rigid_per_kg,
                                 double force_noise_N) {
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
  if (std::any_of(modes.begin(), modes.end(), [](const ModalContribution& mode) { return mode.gain_std > 0; })) {
    const auto common = force.response([&](Complex s) {
      Complex sum = 0;
      for (const ModalContribution& mode : modes) sum += mode.gain_std * receptance(mode.pole, mode.residue_per_kg, s);
      return sum;
    });
    for (std::size_t i = 0; i < common.size(); ++i) out.std_m[i] += common[i] * common[i];
  }
  if (force_noise_N > 0) add_force_noise(force_N, fs_Hz, total, force_noise_N, out.std_m);
  for (double& std : out.std_m) std = std::sqrt(std);
  return out;
}

}  // namespace percuss::metrics
