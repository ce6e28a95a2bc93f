#include "identify/decay/companion_decays.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kMinChannels = 3;    // fewer do not tell shapes apart
constexpr std::size_t kMinCompanions = 2;  // a mode with one companion may be a pair of modes
constexpr double kReach = 0.03;            // of the mode's frequency
constexpr double kWeak = 0.5;              // of the mode's amplitude; a stronger companion must be within kClose
constexpr double kClose = 3;               // half-power bandwidths of the broader decay
constexpr double kMinMac = 0.8;

double amplitude_of(const DecayMode& decay) {
  double sum_over_hits = 0, sum_over_channels = 0;
  for (const HitAmplitude& hit : decay.hits) sum_over_hits += std::norm(hit.value);
  for (const Residue& residue : decay.mode.residues) sum_over_channels += std::norm(residue.value);
  return std::sqrt(sum_over_hits * sum_over_channels);
}

bool have_one_shape(const Mode& a, const Mode& b) {
  double aa = 0, bb = 0, chi2 = 0, freedom = 0;
  Complex ab = 0;
  for (std::size_t c = 0; c < a.residues.size(); ++c) {
    const Residue &one = a.residues[c], &other = b.residues[c];
    aa += std::norm(one.value);
    bb += std::norm(other.value);
    ab += std::conj(one.value) * other.value;
    const double variance = one.std * one.std + other.std * other.std;
    if (!(variance > 0)) continue;  // the reference channel: 1 by definition
    chi2 += std::norm(one.value - other.value) / variance;
    freedom += 2;
  }
  return freedom > 0 && std::norm(ab) > kMinMac * aa * bb && chi2_deviate(chi2, freedom) < kOnceIn1000;
}

bool may_be_companion(const DecayMode& of, const DecayMode& other) {
  const Pole &main = of.mode.pole, &pole = other.mode.pole;
  const double apart_Hz = std::abs(pole.freq_Hz - main.freq_Hz), reach_Hz = kReach * main.freq_Hz;
  const double width_Hz = std::max(main.half_power_Hz(), pole.half_power_Hz());
  if (apart_Hz > reach_Hz || width_Hz > reach_Hz) return false;
  const double relative = amplitude_of(other) / amplitude_of(of);
  return relative < 1 && (relative < kWeak || apart_Hz < kClose * width_Hz) && have_one_shape(of.mode, other.mode);
}

// The variance that the companions add: their distance from the mode, weighted by energy.
void widen(DecayMode& main) {
  double weights = main.energy, freq = 0, damping = 0;
  for (const DecayMode& other : main.companions) {
    weights += other.energy;
    freq += other.energy * std::pow(other.mode.pole.freq_Hz - main.mode.pole.freq_Hz, 2);
    damping += other.energy * std::pow(other.mode.pole.damping_ratio - main.mode.pole.damping_ratio, 2);
  }
  StdParts &of_freq = main.mode.freq_std_parts_Hz, &of_damping = main.mode.damping_std_parts;
  of_freq.misfit = std::hypot(of_freq.misfit, std::sqrt(freq / weights));
  of_damping.misfit = std::hypot(of_damping.misfit, std::sqrt(damping / weights));
  main.mode.freq_std_Hz = of_freq.total();
  main.mode.damping_std = of_damping.total();
}

// Moves the companions of `main` out of `from`.
void take_companions(std::vector<DecayMode>& from, const DecayMode& main, std::vector<DecayMode>& to) {
  const auto rest = std::stable_partition(from.begin(), from.end(),
                                          [&](const DecayMode& other) { return !may_be_companion(main, other); });
  std::move(rest, from.end(), std::back_inserter(to));
  from.erase(rest, from.end());
}

std::size_t count_companions(const DecayMode& main, const std::vector<DecayMode>& among) {
  return static_cast<std::size_t>(
      std::count_if(among.begin(), among.end(), [&](const DecayMode& other) { return may_be_companion(main, other); }));
}

}  // namespace

void gather_companions(DecayResults& found) {
  if (found.modes.empty() || found.modes.front().mode.residues.size() < kMinChannels) return;
  std::vector<double> amplitudes;  // the strongest decay first; modes move while they are gathered
  for (const DecayMode& mode : found.modes) amplitudes.push_back(amplitude_of(mode));
  std::sort(amplitudes.rbegin(), amplitudes.rend());
  for (const double amplitude : amplitudes) {
    const auto own = std::find_if(found.modes.begin(), found.modes.end(),
                                  [&](const DecayMode& mode) { return amplitude_of(mode) == amplitude; });
    if (own == found.modes.end()) continue;  // a companion by now
    DecayMode main = *own;
    if (count_companions(main, found.modes) + count_companions(main, found.tones) < kMinCompanions) continue;
    std::vector<DecayMode> companions;
    take_companions(found.modes, main, companions);
    take_companions(found.tones, main, companions);
    std::sort(companions.begin(), companions.end(),
              [](const DecayMode& a, const DecayMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
    const auto place = std::find_if(found.modes.begin(), found.modes.end(),
                                    [&](const DecayMode& mode) { return amplitude_of(mode) == amplitude; });
    place->companions = std::move(companions);
    widen(*place);
  }
}

}  // namespace percuss::identify
