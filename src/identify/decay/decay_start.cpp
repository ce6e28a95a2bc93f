#include "identify/decay/decay_start.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/significance.hpp"
#include "identify/decay/noise_prediction.hpp"

namespace percuss::identify {
namespace {

constexpr double kSafe_s = 20e-3, kSafeShare = 1.0 / 8;  // of safe_start()
constexpr double kMinSafe_s = 5e-3;                      // longer than the contact of a ball
constexpr std::size_t kBackBlock = 8;                    // samples
constexpr std::size_t kMaxBlocks = 16;                   // that are tested together
constexpr std::size_t kAfter = 16;  // samples after the start, from which those before are predicted
constexpr double kAlarm = 4;        // normal deviate of a sum's χ²
constexpr int kMaxMoves = 4;
constexpr double kWorthwhile = 0.05;  // of the start: a smaller move changes nothing

// The expected prediction errors of one response before the start of the decays.
struct Expected {
  const FreeDecayFit* fit = nullptr;
  Eigen::Index signal = 0;
  NoisePrediction prediction{};
  double fs_Hz = 0;

  // The variance of an error `before_s` seconds before the start, from the noise and from the uncertainty of the
  // decays.
  double variance(double before_s) const {
    double sum = prediction.error_variance;
    for (const FittedDecay& decay : fit->decays) {
      const double at_start = decay.noise(signal) * decay.inverse_gram.trace() / 2;
      const double growth = std::exp(std::min(200.0, -2 * decay.rate.rate_radps.real() * before_s));
      sum += at_start * growth * prediction.gain(decay.rate, fs_Hz);
    }
    return sum;
  }
};

// The constant of each response that the fit leaves out.
std::vector<double> constants(const FreeDecays& whole, const FreeDecayFit& fit, std::size_t start) {
  std::vector<double> out;
  for (const std::vector<double>& one : whole.response) {
    double sum = 0;
    for (std::size_t n = start; n < one.size(); ++n) sum += one[n];
    out.push_back(sum / static_cast<double>(one.size() - start));
  }
  const DecaySpectra shape{.fs_Hz = whole.fs_Hz, .samples = whole.samples() - start, .lines = {}};
  for (const FittedDecay& decay : fit.decays) {
    const Eigen::RowVector2cd dc = decay_values(decay.rate, shape, 0, 1).row(0) / static_cast<double>(shape.samples);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Complex a = decay.amplitude(static_cast<Eigen::Index>(i));
      out[i] -= dc(0).real() * a.real() + dc(1).real() * a.imag();
    }
  }
  return out;
}

// The responses minus the decays, extrapolated back, from the first sample to kAfter samples beyond the start.
std::vector<std::vector<double>> residuals(const FreeDecays& whole, const FreeDecayFit& fit, std::size_t start) {
  const std::vector<double> bias = constants(whole, fit, start);
  const std::size_t samples = std::min(start + kAfter, whole.samples());
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < whole.response.size(); ++i) {
    out.emplace_back(whole.response[i].begin(), whole.response[i].begin() + static_cast<std::ptrdiff_t>(samples));
    for (double& value : out.back()) value -= bias[i];
    subtract_decays(fit, whole.fs_Hz, i, start, out.back());
  }
  return out;
}

// χ² of the prediction errors in each block of kBackBlock samples before the start. The first one ends at the start.
std::vector<double> block_chi2(const FreeDecays& whole, const FreeDecayFit& fit, std::size_t start) {
  const std::vector<std::vector<double>> rest = residuals(whole, fit, start);
  std::vector<double> out(start / kBackBlock, 0.0);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto signal = static_cast<Eigen::Index>(i);
    const Expected expected{.fit = &fit,
                            .signal = signal,
                            .prediction = noise_prediction(fit.noise.col(signal), whole.samples() - start),
                            .fs_Hz = whole.fs_Hz};
    for (std::size_t b = 0; b < out.size(); ++b) {
      const std::size_t first = start - (b + 1) * kBackBlock;
      const double variance = expected.variance(static_cast<double>(start - first) / whole.fs_Hz);
      double square = 0;
      for (std::size_t n = first; n < first + kBackBlock; ++n)
        square += std::pow(expected.prediction.error(rest[i], n), 2);
      out[b] += square / variance;
    }
  }
  return out;
}

// The records from a sample on.
FreeDecays decays_from(const FreeDecays& whole, std::size_t first) {
  FreeDecays out{.fs_Hz = whole.fs_Hz, .hits = whole.hits, .channels = whole.channels, .response = {}};
  for (const std::vector<double>& one : whole.response)
    out.response.emplace_back(one.begin() + static_cast<std::ptrdiff_t>(first), one.end());
  return out;
}

// The earliest sample of `whole` from which the fitted decays explain the records. `fit` is of decays_from(whole,
// start). The decays are extrapolated back from `start`, block by block, until the residual exceeds the noise: there
// the force still acts.
std::size_t earliest_start(const FreeDecays& whole, const FreeDecayFit& fit, std::size_t start) {
  const std::vector<double> chi2 = block_chi2(whole, fit, start);
  const auto freedom = static_cast<double>(kBackBlock * whole.response.size());
  for (std::size_t b = 0; b < chi2.size(); ++b) {
    // A weak force that ends slowly exceeds the noise in a sum over several blocks only.
    double sum = 0;
    for (std::size_t blocks = 1; blocks <= std::min(kMaxBlocks, b + 1); ++blocks) {
      sum += chi2[b + 1 - blocks];
      const bool tested = (blocks & (blocks - 1)) == 0;
      if (!tested || chi2_deviate(sum, static_cast<double>(blocks) * freedom) < kAlarm) continue;
      // A weak force may still act in the block after the blocks that exceed the limit: it is left out, too.
      return std::min(start, start - (b + 1) * kBackBlock + (blocks + 1) * kBackBlock);
    }
  }
  return start - chi2.size() * kBackBlock;
}

}  // namespace

std::size_t safe_start(std::size_t samples, double fs_Hz) {
  return static_cast<std::size_t>(std::min(kSafe_s * fs_Hz, kSafeShare * static_cast<double>(samples)));
}

void subtract_decays(const FreeDecayFit& fit, double fs_Hz, std::size_t signal, std::size_t start,
                     std::span<double> x) {
  for (const FittedDecay& decay : fit.decays) {
    const Complex amplitude = decay.amplitude(static_cast<Eigen::Index>(signal));
    const Complex step = std::exp(decay.rate.rate_radps / fs_Hz);
    Complex now = std::exp(decay.rate.rate_radps * (-static_cast<double>(start) / fs_Hz));
    for (double& value : x) {
      value -= (amplitude * now).real();
      now *= step;
    }
  }
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
