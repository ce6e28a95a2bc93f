#include "pipeline/findings/tones.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"
#include "core/units.hpp"
#include "pipeline/findings/sinusoids.hpp"
#include "pipeline/findings/tone_evidence.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinSamples = 4096;  // of a row: shorter ones do not separate tones from modes
constexpr double kAboveFloor = 40;         // times the median power around: 1 of 10 000 noise lines exceeds 13 times
constexpr double kAboveFlank = 4;          // times the lines just beyond the window's main lobe
constexpr std::size_t kFlankLines = 3;
constexpr std::size_t kFloorLines = 24;  // on either side
constexpr std::size_t kMaxTones = 60;
constexpr std::size_t kMaxHarmonic = 20;
constexpr double kSameHarmonic = 0.5;  // lines of the segment's transform

std::vector<double> powers(std::span<const double> x, const Segment& segment, const std::vector<double>& window) {
  std::vector<double> block(segment.length);
  for (std::size_t n = 0; n < block.size(); ++n) block[n] = window[n] * x[segment.first + n];
  const std::vector<Complex> lines = real_dft_once(block);
  std::vector<double> power(lines.size());
  std::transform(lines.begin(), lines.end(), power.begin(), [](Complex line) { return std::norm(line); });
  return power;
}

bool is_narrow_peak(const std::vector<double>& power, std::size_t k) {
  if (power[k] < power[k - 1] || power[k] <= power[k + 1]) return false;
  for (std::size_t i = kMainLobe + 1; i <= kMainLobe + kFlankLines; ++i) {
    if (power[k] < kAboveFlank * power[k + i] || (k > i && power[k] < kAboveFlank * power[k - i])) return false;
  }
  const std::size_t below = k > kMainLobe + kFloorLines ? k - kMainLobe - kFloorLines : 0;
  const auto at = [&](std::size_t i) { return power.begin() + static_cast<std::ptrdiff_t>(i); };
  std::vector<double> around(at(below), at(k - kMainLobe));
  around.insert(around.end(), at(k + kMainLobe + 1), at(k + kMainLobe + 1 + kFloorLines));
  return power[k] > kAboveFloor * median(std::move(around));
}

std::vector<double> distinct(std::vector<double> turns, std::size_t length) {
  std::sort(turns.begin(), turns.end());
  const double least = static_cast<double>(kMainLobe) / 2 / static_cast<double>(length);
  const auto same = [&](double a, double b) { return b - a < least; };
  turns.erase(std::unique(turns.begin(), turns.end(), same), turns.end());
  if (turns.size() > kMaxTones) turns.resize(kMaxTones);
  return turns;
}

void add_tone(ToneFit& fit, std::span<const ToneSignal> signals, const std::vector<Complex>& amplitude, double turns,
              double fs_Hz) {
  Tone tone{.freq_Hz = turns * fs_Hz, .wanders = wanders_along(signals, turns)};
  for (std::size_t s = 0; s < signals.size(); ++s) {
    const double size = std::abs(amplitude[s]);
    if (signals[s].largest > 0) tone.share = std::max(tone.share, size / signals[s].largest);
    fit.amplitudes[s].push_back(amplitude[s]);
  }
  fit.tones.push_back(tone);
}

double power_of(const std::vector<Complex>& amplitude) {
  double power = 0;
  for (const Complex value : amplitude) power += std::norm(value);
  return power;
}

struct PowerAround {
  double power = 0, below = 0, above = 0;  // of a sinusoid, and on either side of it
};

PowerAround power_around(std::span<const ToneSignal> signals, const std::vector<double>& window, double turns) {
  const double beside = 1.5 * static_cast<double>(kMainLobe) / static_cast<double>(window.size());
  const auto power = [&](double at) { return power_of(amplitudes_of(signals, window, at)); };
  return {.power = power(turns), .below = power(turns - beside), .above = power(turns + beside)};
}

// Power of a sinusoid over the power beside it.
double power_to_noise(std::span<const ToneSignal> signals, const std::vector<double>& window, double turns) {
  const PowerAround found = power_around(signals, window, turns);
  return found.power / (0.5 * (found.below + found.above));
}

// The fundamental of the mains, in turns per sample, from all tones that are its harmonics, each weighted by the
// inverse variance of its frequency. Nothing without a tone at the fundamental.
std::optional<double> mains_of(const std::vector<Tone>& tones, std::span<const ToneSignal> signals,
                               const std::vector<double>& window, double fs_Hz) {
  const double line = 1 / static_cast<double>(window.size());
  const auto base =
      std::find_if(tones.begin(), tones.end(), [](const Tone& tone) { return may_be_mains(tone.freq_Hz); });
  if (base == tones.end()) return std::nullopt;
  double sum = 0, weights = 0;
  for (const Tone& tone : tones) {
    const double order = std::round(tone.freq_Hz / base->freq_Hz), turns = tone.freq_Hz / fs_Hz;
    if (order < 1 || std::abs(turns / order - base->freq_Hz / fs_Hz) > kSameHarmonic * line) continue;
    const double weight = power_to_noise(signals, window, turns) * order;
    sum += weight * turns;
    weights += weight * order;
  }
  return sum / weights;
}

// Whether a harmonic of the mains stands out. On one side, a strong mode may hide it: then it must be steady.
bool stands_out(std::span<const ToneSignal> signals, const std::vector<double>& window, double turns) {
  const PowerAround found = power_around(signals, window, turns);
  if (found.power > kAboveFlank * 0.5 * (found.below + found.above)) return true;
  return found.power > kAboveFloor * std::min(found.below, found.above) && !wanders_between_segments(signals, turns);
}

// Puts the harmonics of the mains at the multiples of their common fundamental. Adds missing harmonics: a harmonic may
// have no peak of its own in the first hit, or by chance equal phases at all hits.
void add_mains(ToneFit& fit, std::span<const ToneSignal> signals, const std::vector<double>& window, double fs_Hz) {
  const double line = 1 / static_cast<double>(window.size());
  const std::optional<double> base = mains_of(fit.tones, signals, window, fs_Hz);
  if (!base) return;
  ToneFit out{.tones = {}, .amplitudes = std::vector<std::vector<Complex>>(signals.size())};
  std::vector<bool> known(kMaxHarmonic + 1);
  const bool steady = std::none_of(fit.tones.begin(), fit.tones.end(),
                                   [](const Tone& tone) { return may_be_mains(tone.freq_Hz) && tone.wanders; });
  const auto add_harmonic = [&](double order) {
    const double turns = order * *base;
    add_tone(out, signals, amplitudes_of(signals, window, turns), turns, fs_Hz);
    // Harmonics of steady mains are steady. A change from half to half may come from a mode nearby that still rings.
    Tone& tone = out.tones.back();
    if (tone.wanders && order > 1 && steady) tone.wanders = wanders_between_segments(signals, turns);
  };
  for (const Tone& tone : fit.tones) {
    const double turns = tone.freq_Hz / fs_Hz, order = std::round(turns / *base);
    if (order >= 1 && order <= static_cast<double>(kMaxHarmonic) && std::abs(turns - order * *base) < line) {
      known[static_cast<std::size_t>(order)] = true;
      add_harmonic(order);
    } else {
      add_tone(out, signals, amplitudes_of(signals, window, turns), turns, fs_Hz);
    }
  }
  for (std::size_t k = 2; k <= kMaxHarmonic && static_cast<double>(k) * *base < 0.5 - line; ++k) {
    const double turns = static_cast<double>(k) * *base;
    if (!known[k] && refined_turns_per_sample(signals, window, turns) > 0 && stands_out(signals, window, turns))
      add_harmonic(static_cast<double>(k));
  }
  fit = std::move(out);
}

}  // namespace

std::vector<double> tone_candidates(std::span<const double> x) {
  if (x.size() < kMinSamples) return {};
  const Segment early = early_segment(x.size()), late = late_segment(x.size());
  const std::vector<double> window = window_of(late.length);
  const std::vector<double> power = powers(x, late, window);
  std::vector<double> before;  // computed at the first narrow peak: most responses have none
  std::vector<double> found;
  for (std::size_t k = kMainLobe + 1; k + kMainLobe + kFloorLines + 1 < power.size(); ++k) {
    if (!is_narrow_peak(power, k)) continue;
    if (before.empty()) before = powers(x, early, window);
    // Keeps peaks with about equal power in both segments.
    if (std::abs(power[k] / before[k] - 1) > 2 * kSteady) continue;
    found.push_back(static_cast<double>(k) / static_cast<double>(late.length));
  }
  return found;
}

ToneFit find_tones(std::span<const ToneSignal> signals, std::vector<double> candidates, double fs_Hz) {
  ToneFit fit{.tones = {}, .amplitudes = std::vector<std::vector<Complex>>(signals.size())};
  if (signals.empty()) return fit;
  const std::size_t length = segment_length(signals.front().x.size());
  const std::vector<double> window = window_of(length);
  for (const double candidate : distinct(std::move(candidates), length)) {
    const double turns = refined_turns_per_sample(signals, window, candidate);
    if (!(turns > 0)) continue;
    const std::vector<Complex> amplitude = amplitudes_of(signals, window, turns);
    if (has_free_phase(signals, amplitude, turns) || is_there_before(signals, amplitude, turns))
      add_tone(fit, signals, amplitude, turns, fs_Hz);
  }
  add_mains(fit, signals, window, fs_Hz);
  return fit;
}

void subtract_tones(const ToneFit& fit, std::size_t s, double fs_Hz, std::span<double> x) {
  for (std::size_t t = 0; t < fit.tones.size(); ++t) {
    if (fit.tones[t].wanders) continue;
    const double turns = fit.tones[t].freq_Hz / fs_Hz;
    const Complex step = std::polar(1.0, kTwoPi * turns);
    Complex value;
    for (std::size_t n = 0; n < x.size(); ++n) {
      value = n % kRestart == 0
                  ? fit.amplitudes[s][t] * std::polar(1.0, kTwoPi * std::fmod(turns * static_cast<double>(n), 1.0))
                  : value * step;
      x[n] -= value.real();
    }
  }
}

}  // namespace percuss::pipeline
