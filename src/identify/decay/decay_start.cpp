#include "identify/decay/decay_start.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace percuss::identify {
namespace {

constexpr double kSafe_s = 20e-3, kSafeShare = 1.0 / 8;  // of safe_start()
constexpr double kMinSafe_s = 5e-3;                      // longer than the contact of a ball
constexpr std::size_t kBackBlock = 8;                    // samples
constexpr double kAlarm = 4;                             // standard deviations of a block's mean square
constexpr int kMaxMoves = 4;
constexpr double kWorthwhile = 0.05;  // of the start: a smaller move changes nothing

// Per hit and channel: the variance of a sample in the residual, from the noise and from the uncertainty of the decays
// `before_s` seconds before their start.
struct Expected {
  Eigen::VectorXd noise;
  const FreeDecayFit* fit = nullptr;
  double variance(Eigen::Index signal, double before_s) const {
    double sum = noise(signal);
    for (const FittedDecay& decay : fit->decays) {
      sum += decay.noise(signal) * decay.inverse_gram.trace() / 2 *
             std::exp(std::min(200.0, -2 * decay.rate.rate_radps.real() * before_s));
    }
    return sum;
  }
};

Expected expected_of(const FreeDecayFit& fit, std::size_t samples) {
  // Σ_k |R(k)|² of the one-sided lines is N²/2 of a sample's variance.
  return {.noise = fit.noise.colwise().sum().transpose() * 2 / std::pow(static_cast<double>(samples), 2), .fit = &fit};
}

}  // namespace

std::size_t safe_start(std::size_t samples, double fs_Hz) {
  return static_cast<std::size_t>(std::min(kSafe_s * fs_Hz, kSafeShare * static_cast<double>(samples)));
}

FreeDecays decays_from(const FreeDecays& whole, std::size_t first) {
  FreeDecays out{.fs_Hz = whole.fs_Hz, .hits = whole.hits, .channels = whole.channels, .response = {}};
  for (const std::vector<double>& one : whole.response)
    out.response.emplace_back(one.begin() + static_cast<std::ptrdiff_t>(first), one.end());
  return out;
}

std::size_t earliest_start(const FreeDecays& whole, const FreeDecayFit& fit, std::size_t start) {
  const Expected expected = expected_of(fit, whole.samples() - start);
  std::vector<double> bias;  // the constant that the fit leaves out
  for (const std::vector<double>& one : whole.response) {
    double sum = 0;
    for (std::size_t n = start; n < one.size(); ++n) sum += one[n];
    bias.push_back(sum / static_cast<double>(one.size() - start));
  }
  for (std::size_t i = 0; i < bias.size(); ++i) {
    for (const FittedDecay& decay : fit.decays) {
      const DecaySpectra shape{.fs_Hz = whole.fs_Hz, .samples = whole.samples() - start, .lines = {}};
      const DecayColumns dc = decay_columns(decay.rate, shape, 0, 1);
      const Complex a = decay.amplitude(static_cast<Eigen::Index>(i));
      bias[i] -=
          (dc.value(0, 0).real() * a.real() + dc.value(0, 1).real() * a.imag()) / static_cast<double>(shape.samples);
    }
  }
  std::size_t first = start;
  while (first >= kBackBlock) {
    double square = 0;
    for (std::size_t n = first - kBackBlock; n < first; ++n) {
      const double t_s = (static_cast<double>(n) - static_cast<double>(start)) / whole.fs_Hz;
      for (std::size_t i = 0; i < whole.response.size(); ++i) {
        double rest = whole.response[i][n] - bias[i];
        for (const FittedDecay& decay : fit.decays)
          rest -= (decay.amplitude(static_cast<Eigen::Index>(i)) * std::exp(decay.rate.rate_radps * t_s)).real();
        square += rest * rest / expected.variance(static_cast<Eigen::Index>(i), -t_s);
      }
    }
    const auto count = static_cast<double>(kBackBlock * whole.response.size());
    // In the block after the one that exceeds the limit, a weak force may still act: that block is left out, too.
    if (!(square / count < 1 + kAlarm * std::sqrt(2 / count))) return std::min(start, first + kBackBlock);
    first -= kBackBlock;
  }
  return first;
}

StartedFit fit_from_earliest_start(const FreeDecays& whole, std::size_t safe, const FreeDecayOptions& options) {
  FreeDecayOptions begun = options;
  const auto fit_from = [&](std::size_t first) {
    return fit_free_decays(decay_spectra(decays_from(whole, first)), begun);
  };
  StartedFit out{.fit = fit_from(safe), .start = safe};
  // Fast decays of weak records may have gone by then.
  for (std::size_t half = safe / 2; out.fit.decays.empty() && static_cast<double>(half) >= kMinSafe_s * whole.fs_Hz;
       half /= 2)
    out = {.fit = fit_from(half), .start = half};
  for (int move = 0; move < kMaxMoves && out.fit.complete; ++move) {
    const std::size_t first = earliest_start(whole, out.fit, out.start);
    if (static_cast<double>(out.start - first) <= kWorthwhile * static_cast<double>(out.start)) break;
    begun.initial.clear();
    for (const FittedDecay& decay : out.fit.decays) begun.initial.push_back(decay.rate);
    begun.start_Hz.clear();
    out = {.fit = fit_from(first), .start = first};
  }
  return out;
}

}  // namespace percuss::identify
