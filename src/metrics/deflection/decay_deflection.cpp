#include "metrics/deflection/decay_deflection.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "identify/decay/decay_start.hpp"

namespace percuss::metrics {
namespace {

constexpr std::size_t kMinSamples = 64, kMaxSamples = std::size_t{1} << 15U;
constexpr double kMinBandLines = 0.7;  // lower end of the band, in spectral lines
constexpr double kAntiAlias = 0.44;    // upper end, as part of the sampling rate
// More than any bat has. The search would take minutes where something else than free decays is in the record, such as
// a second blow.
constexpr std::size_t kMaxDecays = 40;

}  // namespace

std::optional<DecayDeflection> decay_deflection(std::span<const double> accel_mps2, double fs_Hz, std::size_t onset,
                                                double highpass_corner_Hz) {
  if (accel_mps2.size() < onset + kMinSamples) return std::nullopt;
  const std::size_t samples = std::min(kMaxSamples, accel_mps2.size() - onset);
  const auto moving = accel_mps2.subspan(onset, samples);
  const identify::FreeDecays whole{
      .fs_Hz = fs_Hz, .hits = 1, .channels = 1, .response = {{moving.begin(), moving.end()}}};
  const std::size_t safe = identify::safe_start(samples, fs_Hz);
  const double df_Hz = fs_Hz / static_cast<double>(samples - safe);
  const identify::StartedFit started = identify::fit_from_earliest_start(
      whole, safe, {.band_Hz = {kMinBandLines * df_Hz, kAntiAlias * fs_Hz}, .max_decays = kMaxDecays});
  if (started.fit.decays.empty() || !started.fit.complete) return std::nullopt;
  DecayDeflection out{.first = onset + started.start, .deflection_m = {}, .std_m = {}};
  const std::size_t count = accel_mps2.size() - out.first;
  out.deflection_m.assign(count, 0);
  std::vector<double> variance(count, 0);
  for (const identify::FittedDecay& decay : started.fit.decays) {
    const Complex s = decay.rate.rate_radps;
    const Complex integral = (s + kTwoPi * highpass_corner_Hz) / (s * s * s);
    const double of_amplitude = decay.noise(0) * decay.inverse_gram.trace() / 2;
    const double of_rate = std::norm(decay.amplitude(0)) * decay.covariance.trace() / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const double t_s = static_cast<double>(i) / fs_Hz;
      const Complex swing = integral * std::exp(s * t_s);
      out.deflection_m[i] += (decay.amplitude(0) * swing).real();
      variance[i] += std::norm(swing) * (of_amplitude + of_rate * t_s * t_s);
    }
  }
  for (const double one : variance) out.std_m.push_back(std::sqrt(one));
  return out;
}

}  // namespace percuss::metrics
