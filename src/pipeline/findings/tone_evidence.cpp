#include "pipeline/findings/tone_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/units.hpp"
#include "pipeline/findings/sinusoids.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinPhases = 4;                 // that show whether the phase is fixed to the hit
constexpr double kMinForce = 0.01;                    // of the pulse's area: its spectrum below this has no sure phase
constexpr double kFixedPhase = 0.85;                  // resultant length of the doubled phases; 1 for a mode
constexpr double kMinBefore = 0.5, kMaxBefore = 1.5;  // amplitude before the hits over the tone's amplitude
constexpr double kBeforeClear = 5;                    // standard deviations
constexpr double kMaxWander = 0.01;                   // of the power: 0.14 rad between the halves
constexpr double kWanderNoise = 3;                    // times the power beside the tone

// The phase factor of the pulse's spectrum; nothing where the pulse has hardly any force at this frequency.
std::optional<Complex> force_direction(const ToneSignal& signal, double turns) {
  Complex sum;
  double most = 0;
  for (std::size_t n = 0; n < signal.pulse_N.size(); ++n) {
    sum += signal.pulse_N[n] * std::polar(1.0, -kTwoPi * turns * static_cast<double>(signal.pulse_first + n));
    most += std::abs(signal.pulse_N[n]);
  }
  if (!(std::abs(sum) > kMinForce * most)) return std::nullopt;
  return sum / std::abs(sum);
}

}  // namespace

bool has_free_phase(std::span<const ToneSignal> signals, const std::vector<Complex>& amplitude, double turns) {
  Complex resultant;
  double power = 0;
  std::set<std::size_t> hits;
  for (std::size_t s = 0; s < signals.size(); ++s) {
    const std::optional<Complex> force = force_direction(signals[s], turns);
    if (!force) continue;
    const Complex relative = amplitude[s] * std::conj(*force);
    resultant += relative * relative;
    power += std::norm(relative);
    hits.insert(signals[s].hit);
  }
  return hits.size() >= kMinPhases && std::abs(resultant) < kFixedPhase * power;
}

bool is_there_before(std::span<const ToneSignal> signals, const std::vector<Complex>& amplitude, double turns) {
  double product = 0, square = 0, energy = 0, count = 0;
  for (std::size_t s = 0; s < signals.size(); ++s) {
    const auto before = signals[s].before, rest = signals[s].x.first(signals[s].quiet);
    std::vector<double> quiet(before.begin(), before.end());
    quiet.insert(quiet.end(), rest.begin(), rest.end());
    std::vector<double> tone(quiet.size());
    const auto first = -static_cast<double>(before.size());
    double mean = 0, tone_mean = 0;
    for (std::size_t n = 0; n < quiet.size(); ++n) {
      tone[n] = (amplitude[s] * std::polar(1.0, kTwoPi * turns * (first + static_cast<double>(n)))).real();
      mean += quiet[n] / static_cast<double>(quiet.size());
      tone_mean += tone[n] / static_cast<double>(quiet.size());
    }
    for (std::size_t n = 0; n < quiet.size(); ++n) {
      product += (quiet[n] - mean) * (tone[n] - tone_mean);
      square += (tone[n] - tone_mean) * (tone[n] - tone_mean);
      energy += (quiet[n] - mean) * (quiet[n] - mean);
    }
    count += static_cast<double>(quiet.size());
  }
  if (!(square > 0)) return false;
  const double found = product / square;
  const double std = std::sqrt(energy / count / square);
  return found > std::max(kMinBefore, kBeforeClear * std) && found < kMaxBefore;
}

bool wanders_along(std::span<const ToneSignal> signals, double turns) {
  const Segment late = late_segment(signals.front().x.size());
  const Segment first{late.first, late.length / 2}, second{late.first + late.length / 2, late.length / 2};
  const std::vector<double> window = window_of(late.length / 2);
  const double beside = turns + 1.5 * static_cast<double>(kMainLobe) / static_cast<double>(first.length);
  double change = 0, power = 0, noise = 0;
  for (const ToneSignal& signal : signals) {
    const auto at = [&](const Segment& half, double f) { return amplitude_in(signal.x, half, window, f); };
    const Complex a = at(first, turns), b = at(second, turns);
    change += std::norm(b - a);
    power += std::norm(a) + std::norm(b);
    noise += std::norm(at(first, beside)) + std::norm(at(second, beside));
  }
  return change > kMaxWander * power + kWanderNoise * noise;
}

bool wanders_between_segments(std::span<const ToneSignal> signals, double turns) {
  const std::size_t samples = signals.front().x.size();
  const Segment early = early_segment(samples), late = late_segment(samples);
  const std::vector<double> window = window_of(late.length);
  const double apart = 1.5 * static_cast<double>(kMainLobe) / static_cast<double>(late.length);
  double change = 0, power = 0, below = 0, above = 0;
  for (const ToneSignal& signal : signals) {
    const auto at = [&](const Segment& part, double f) { return amplitude_in(signal.x, part, window, f); };
    const auto both = [&](double f) { return std::norm(at(early, f)) + std::norm(at(late, f)); };
    change += std::norm(at(late, turns) - at(early, turns));
    power += both(turns);
    below += both(turns - apart);
    above += both(turns + apart);
  }
  // The smaller of the two sides is the noise: on the other side there may be a mode.
  return change > kMaxWander * power + kWanderNoise * std::min(below, above);
}

}  // namespace percuss::pipeline
