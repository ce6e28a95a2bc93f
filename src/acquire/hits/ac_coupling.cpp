#include "acquire/hits/ac_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.hpp"

namespace percuss::acquire {
namespace {

constexpr double kMinLength_s = 0.02;      // shorter stretches after the pulse show no decay
constexpr double kMaxLength_s = 0.25;      // longer ones add the error of the baseline
constexpr std::size_t kMinRest = 16;       // samples before the pulse
constexpr double kMinSignificance = 8;     // standard deviations of the undershoot
constexpr double kMaxContradiction = 0.2;  // largest deviation, relative to the return expected at the end
constexpr double kMaxEarly = 0.9;          // of the pulse's integral, returned in the early part

// Integral of the force above its level of rest before the pulse.
double integral_of(std::span<const double> x, double rest_N, double fs_Hz) {
  return (std::accumulate(x.begin(), x.end(), 0.0) - rest_N * static_cast<double>(x.size())) / fs_Hz;
}

}  // namespace

double ac_coupling_Hz(const Hit& hit, std::span<const double> x, double fs_Hz) {
  const std::size_t before = hit.gate_first - hit.first, end = before + hit.gated_N.size();
  if (before < kMinRest || end >= x.size()) return 0;
  // The baseline of the row may include the undershoot.
  const auto rest = x.first(before);
  const double rest_N = std::accumulate(rest.begin(), rest.end(), 0.0) / static_cast<double>(before);
  const auto after = x.subspan(end, std::min(x.size() - end, static_cast<std::size_t>(kMaxLength_s * fs_Hz)));
  const double length_s = static_cast<double>(after.size()) / fs_Hz;
  const double pulse_Ns = integral_of(x.subspan(before, end - before), rest_N, fs_Hz);
  if (length_s < kMinLength_s || pulse_Ns == 0) return 0;
  // Halves the early part until it has returned at most kMaxEarly of the pulse's integral.
  auto early = after.first(after.size() / 4);
  const auto returned = [&](std::span<const double> samples) {
    return -integral_of(samples, rest_N, fs_Hz) / pulse_Ns;
  };
  while (returned(early) > kMaxEarly && early.size() > kMinRest) early = early.first(early.size() / 2);
  const double early_s = static_cast<double>(early.size()) / fs_Hz, part = returned(early);
  // The noise of the samples, and of their mean before the pulse.
  const double variance_s2 = early_s / fs_Hz + early_s * early_s / static_cast<double>(before);
  const double std = hit.noise_N * std::sqrt(variance_s2) / std::abs(pulse_Ns);
  if (!(part > kMinSignificance * std) || part > kMaxEarly) return 0;
  const double decay_per_s = -std::log1p(-part) / early_s;
  const double expected = -std::expm1(-decay_per_s * length_s);
  if (std::abs(returned(after) - expected) > kMaxContradiction * expected) return 0;
  return decay_per_s / kTwoPi;
}

}  // namespace percuss::acquire
