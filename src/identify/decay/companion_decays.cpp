#include "identify/decay/companion_decays.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/math/significance.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kMinChannels = 3;    // fewer do not tell shapes apart: the course of the sum must decide
constexpr std::size_t kMinCompanions = 2;  // a mode with one companion may be a pair of modes
constexpr double kReach = 0.03;            // of the mode's frequency
constexpr double kWeak = 0.5;              // of the mode's amplitude; a stronger companion must be within kClose
constexpr double kClose = 3;               // half-power bandwidths of the broader decay
constexpr double kMinMac = 0.8;
// The sum of the parts of one decay, see is_one_decay().
constexpr std::size_t kCourseSteps = 500;
constexpr double kLowest = 0.03;          // of the amplitude at the start: the course ends there
constexpr double kMaxRise = 0.01;         // of the log amplitude, in nepers
constexpr double kMaxReversal = 0.05;     // of the changes of the frequency: those against its main direction
constexpr double kSteady = 0.01;          // half-power bandwidths of the strongest part: such changes do not count
constexpr double kMinRatioOfRates = 1.2;  // between neighbouring decay rates

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
  const std::size_t channels = of.mode.residues.size();
  if (channels < kMinChannels)
    return relative < 1 && apart_Hz < width_Hz && (channels < 2 || have_one_shape(of.mode, other.mode));
  return relative < 1 && (relative < kWeak || apart_Hz < kClose * width_Hz) && have_one_shape(of.mode, other.mode);
}

struct Course {
  std::vector<double> log_amplitude, freq_Hz;  // [steps]
};

// The sum z(t) = Σ a exp(st) of these decays in a hit has the amplitude |z| and the angular frequency Im(z'/z). The
// course ends where the amplitude stays below kLowest of its start. Empty if the amplitudes or rates do not permit it.
Course course_of(const std::vector<const DecayMode*>& parts, std::size_t hit) {
  std::vector<Complex> rates, values, factors;
  double sum = 0, slowest = std::numeric_limits<double>::infinity();
  for (const DecayMode* part : parts) {
    rates.push_back(decay_rate_of(part->mode.pole).rate_radps);
    values.push_back(part->hits[hit].value);
    sum += std::abs(values.back());
    slowest = std::min(slowest, -rates.back().real());
  }
  const double start = std::abs(std::accumulate(values.begin(), values.end(), Complex(0)));
  if (!(start > 0) || !(slowest > 0)) return {};
  const double step_s = std::log(sum / (kLowest * start)) / slowest / static_cast<double>(kCourseSteps);
  for (const Complex& rate : rates) factors.push_back(std::exp(rate * step_s));
  Course out;
  std::size_t end = 0;
  for (std::size_t step = 0; step <= kCourseSteps; ++step) {
    Complex z = 0, slope = 0;
    for (std::size_t p = 0; p < values.size(); ++p) {
      z += values[p];
      slope += rates[p] * values[p];
      values[p] *= factors[p];
    }
    out.log_amplitude.push_back(std::log(std::abs(z)));
    out.freq_Hz.push_back((slope / z).imag() / kTwoPi);
    if (std::abs(z) > kLowest * start) end = step + 1;
  }
  out.log_amplitude.resize(end);
  out.freq_Hz.resize(end);
  return out;
}

// The rises of a quantity, and its falls, in total.
std::pair<double, double> rise_and_fall(const std::vector<double>& values) {
  std::pair<double, double> out{0, 0};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[i - 1];
    (change > 0 ? out.first : out.second) += std::abs(change);
  }
  return out;
}

// Whether the sum of these decays in a hit looks like the decay of one mode: its amplitude only falls, and its
// frequency changes in one direction. Two modes beat instead.
bool falls_without_beats(const std::vector<const DecayMode*>& parts, std::size_t hit) {
  const Course course = course_of(parts, hit);
  if (course.freq_Hz.empty()) return false;
  const auto [rise, fall] = rise_and_fall(course.freq_Hz);
  const double ignored_Hz = kSteady * parts.front()->mode.pole.half_power_Hz();
  return rise_and_fall(course.log_amplitude).first < kMaxRise &&
         std::min(rise, fall) < kMaxReversal * (rise + fall) + ignored_Hz;
}

// Whether few channels, which show no shape, may show the parts of one decay. The amplitude A of a mode falls as
// exp(−σt), and a motion that depends on A is a series of its powers: the parts decay at σ and at multiples of it.
// Close modes of one structure have similar rates, and beat. parts: the strongest first.
bool is_one_decay(const std::vector<const DecayMode*>& parts) {
  std::vector<double> rates_per_s;
  rates_per_s.reserve(parts.size());
  for (const DecayMode* part : parts) rates_per_s.push_back(-decay_rate_of(part->mode.pole).rate_radps.real());
  std::sort(rates_per_s.begin(), rates_per_s.end());
  for (std::size_t i = 1; i < rates_per_s.size(); ++i) {
    if (!(rates_per_s[i] > kMinRatioOfRates * rates_per_s[i - 1])) return false;
  }
  for (std::size_t hit = 0; hit < parts.front()->hits.size(); ++hit) {
    if (!falls_without_beats(parts, hit)) return false;
  }
  return true;
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

// The decays of `among` that may be companions.
std::vector<const DecayMode*> companions_among(const DecayMode& main, const std::vector<DecayMode>& among) {
  std::vector<const DecayMode*> out;
  for (const DecayMode& other : among) {
    if (may_be_companion(main, other)) out.push_back(&other);
  }
  return out;
}

// Moves the companions of `main` out of `from`.
void take_companions(std::vector<DecayMode>& from, const DecayMode& main, std::vector<DecayMode>& to) {
  const auto rest = std::stable_partition(from.begin(), from.end(),
                                          [&](const DecayMode& other) { return !may_be_companion(main, other); });
  std::move(rest, from.end(), std::back_inserter(to));
  from.erase(rest, from.end());
}

std::vector<DecayMode>::iterator find_amplitude(std::vector<DecayMode>& modes, double amplitude) {
  return std::find_if(modes.begin(), modes.end(),
                      [&](const DecayMode& mode) { return amplitude_of(mode) == amplitude; });
}

// Whether the companions of a mode are parts of its decay. With few channels, a tone is none: it may be hum.
bool are_parts(const DecayMode& main, const DecayResults& found) {
  std::vector<const DecayMode*> parts = companions_among(main, found.modes);
  if (main.mode.residues.size() >= kMinChannels)
    return parts.size() + companions_among(main, found.tones).size() >= kMinCompanions;
  if (parts.size() < kMinCompanions) return false;
  parts.insert(parts.begin(), &main);
  return is_one_decay(parts);
}

// Whether a stronger mode names this one as unresolved.
bool is_named_unresolved(const DecayMode& one, const std::vector<DecayMode>& modes) {
  return std::any_of(modes.begin(), modes.end(), [&](const DecayMode& other) {
    const std::vector<double>& named = other.unresolved_Hz;
    return std::find(named.begin(), named.end(), one.mode.pole.freq_Hz) != named.end();
  });
}

// Names the decays near `main`, if there are two or more that few channels cannot tell from parts of its decay.
void note_unresolved(DecayMode& main, const std::vector<DecayMode>& modes) {
  if (main.mode.residues.size() >= kMinChannels) return;
  const std::vector<const DecayMode*> near = companions_among(main, modes);
  if (near.size() < kMinCompanions) return;
  for (const DecayMode* other : near) main.unresolved_Hz.push_back(other->mode.pole.freq_Hz);
}

}  // namespace

void gather_companions(DecayResults& found) {
  std::vector<double> amplitudes;  // the strongest decay first; modes move while they are gathered
  for (const DecayMode& mode : found.modes) amplitudes.push_back(amplitude_of(mode));
  std::sort(amplitudes.rbegin(), amplitudes.rend());
  for (const double amplitude : amplitudes) {
    const auto own = find_amplitude(found.modes, amplitude);
    if (own == found.modes.end() || is_named_unresolved(*own, found.modes))
      continue;  // a companion by now, or near a stronger
    DecayMode main = *own;
    if (!are_parts(main, found)) {
      note_unresolved(*own, found.modes);
      continue;
    }
    std::vector<DecayMode> companions;
    take_companions(found.modes, main, companions);
    if (main.mode.residues.size() >= kMinChannels) take_companions(found.tones, main, companions);
    std::sort(companions.begin(), companions.end(),
              [](const DecayMode& a, const DecayMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
    const auto place = find_amplitude(found.modes, amplitude);
    place->companions = std::move(companions);
    widen(*place);
  }
}

}  // namespace percuss::identify
