#include "metrics/deflection/deflection.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "metrics/deflection/baseline_drift.hpp"
#include "metrics/deflection/baseline_noise.hpp"
#include "metrics/deflection/final_rest.hpp"
#include "metrics/deflection/largest_deflection.hpp"
#include "metrics/deflection/window_mean.hpp"

namespace percuss::metrics {
namespace {

constexpr std::size_t kMinBefore = 8;  // samples at rest needed to estimate a bias
constexpr std::size_t kRinging = 32;   // longest ringing of an anti-alias filter before the onset, in samples
constexpr double kMethodError = 1e-6;  // of the largest deflection: error by rounding and by the filter's first ringing
constexpr double kOnsetNoise = 8;      // standard deviations of the noise that a motion must exceed …
constexpr double kOnsetLevel = 1e-3;   // … and the part of the largest acceleration
constexpr double kGlitch = 0.01;       // of the largest acceleration: a weaker motion is no impact …
constexpr std::ptrdiff_t kQuietAfterGlitch = 64;  // … if this many samples at rest follow it
constexpr std::size_t kMinLevel = 64;             // samples that give a sensor's level
constexpr double kByLine = 0.5;                   // of the peak: a line that makes so much of it …
constexpr double kNoBias = 5;                     // … and so many standard deviations is no bias of the sensor
constexpr double kRigidContradicted = 5;          // standard deviations between the rigid-body motion and the integral
constexpr double kRelevant = 0.02;                // of the largest deflection: modes beyond the band make less
constexpr double kLowestShare = 0.5;              // default lowest frequency over the frequency of the strongest line

double largest_magnitude(std::span<const double> x) { return extremes_of(x).max_distance_from(0); }

// The number of samples at rest: those before the filter's ringing begins.
std::size_t samples_at_rest(const ImpactSignal& signal) {
  const auto onset = static_cast<std::size_t>(std::max(0.0, signal.onset_s * signal.fs_Hz));
  return onset - std::min(kRinging, onset / 2);
}

void prepend_rest(std::vector<double>& values, std::size_t samples) { values.insert(values.begin(), samples, 0.0); }

// The acceleration after the samples at rest, less the line through them, integrated.
struct Integrated {
  std::size_t first = 0;  // sample after the samples at rest
  BaselineEstimate rest;
  std::vector<double> accel_mps2;
  Motion motion;
  std::vector<double> swing_m;  // the deflection without the known rigid-body motion
  bool may_return = false;      // the structure may swing about its position of rest
};

Integrated integrate_after_rest(const ImpactSignal& signal, const DeflectionOptions& options) {
  const std::size_t first = std::min(samples_at_rest(signal), signal.accel_mps2.size() - 1);
  const auto moving = signal.accel_mps2.subspan(first);
  Integrated out{.first = first,
                 .rest = baseline_estimate(signal.accel_mps2.first(first), signal.fs_Hz, rms(moving)),
                 .accel_mps2 = {moving.begin(), moving.end()},
                 .motion = {},
                 .swing_m = {}};
  for (std::size_t i = 0; i < out.accel_mps2.size(); ++i)
    out.accel_mps2[i] -= out.rest.bias(0) + out.rest.bias(1) * static_cast<double>(i) / signal.fs_Hz;
  out.motion =
      signal.motion ? *signal.motion : integrate_twice(out.accel_mps2, signal.fs_Hz, options.highpass_corner_Hz);
  out.swing_m = out.motion.deflection_m;
  const bool rigid_known = signal.rigid_per_kg > 0 && !signal.force_N.empty();
  if (rigid_known) {
    const auto rigid = modal_deflection(signal.force_N.subspan(first), signal.fs_Hz, {}, signal.rigid_per_kg);
    for (std::size_t i = 0; i < out.swing_m.size(); ++i) out.swing_m[i] -= rigid.deflection_m[i];
  }
  out.may_return = rigid_known || !options.free_body;
  return out;
}

BaselineNoise noise_of(const Integrated& integrated, double fs_Hz, double highpass_corner_Hz) {
  return {integrated.rest,
          {.fs_Hz = fs_Hz,
           .highpass_corner_Hz = highpass_corner_Hz,
           .accel_mps2 = integrated.accel_mps2,
           .deflection_m = integrated.swing_m,
           .may_return = integrated.may_return}};
}

struct DriftFree {
  Deflection deflection;
  std::vector<double> levelled_mps2;  // the acceleration less its error, where 1/f noise was found; else empty
};

// The deflection for 1/f noise of a strength above 0; nothing where its error cannot be estimated.
std::optional<DriftFree> drift_free_of_flicker(const ImpactSignal& signal, const DeflectionOptions& options,
                                               const Integrated& integrated, bool held) {
  if (signal.flicker_strength && !(*signal.flicker_strength > 0)) return std::nullopt;
  const BaselineNoise noise = noise_of(integrated, signal.fs_Hz, options.highpass_corner_Hz);
  const double strength = signal.flicker_strength ? *signal.flicker_strength : flicker_strength(noise.log_gains());
  // If the structure returns to rest under white noise alone (`held`) but not under 1/f noise, white noise is kept.
  if (!(strength > 0) || (held && !noise.returns_to_rest())) return std::nullopt;
  auto error = noise.error_at(strength);
  if (!error) return std::nullopt;
  DriftFree out{.deflection = {.method = DeflectionMethod::drift_free,
                               .bias_mps2 = integrated.rest.bias(0) + error->accel_mps2[0],
                               .zero_mean_corrected = noise.returns_to_rest(),
                               .drift_m = error->drift_std_m},
                .levelled_mps2 = integrated.accel_mps2};
  for (std::size_t i = 0; i < out.levelled_mps2.size(); ++i) out.levelled_mps2[i] -= error->accel_mps2[i];
  Motion motion = integrate_twice(out.levelled_mps2, signal.fs_Hz, options.highpass_corner_Hz);
  out.deflection.velocity_mps = std::move(motion.velocity_mps);
  out.deflection.deflection_m = std::move(motion.deflection_m);
  out.deflection.std_m = std::move(error->std_m);
  const double method_error_m = kMethodError * largest_magnitude(out.deflection.deflection_m);
  for (double& std_m : out.deflection.std_m) std_m = std::hypot(std_m, method_error_m);
  return out;
}

// The line through the samples before the impact, less the level of the sensor. 0 where no level is known.
Eigen::Vector2d line_above_level(const ImpactSignal& signal, const BaselineEstimate& rest) {
  if (!signal.level || rest.residual_mps2.empty()) return Eigen::Vector2d::Zero();
  return {rest.bias(0) - signal.level->mps2, rest.bias(1)};
}

// moved_before: the line through the samples before the impact shows a motion, not the bias of the sensor. The
// standard deviation then includes the difference of this line from the sensor's level.
DriftFree drift_free(const ImpactSignal& signal, const DeflectionOptions& options, bool moved_before = false) {
  Integrated integrated = integrate_after_rest(signal, options);
  BaselineEstimate& rest = integrated.rest;
  if (moved_before) rest.covariance.diagonal() += line_above_level(signal, rest).cwiseAbs2();
  ZeroMeanCorrection late{.bias = Eigen::Vector2d::Zero(), .covariance = rest.covariance};
  if (integrated.may_return)
    late = zero_mean_correction(integrated.swing_m, signal.fs_Hz, options.highpass_corner_Hz, rest);
  std::optional<DriftFree> coloured;
  if (!moved_before) coloured = drift_free_of_flicker(signal, options, integrated, late.held);
  // The end of the record is a rest only if the record begins at rest. An amplifier's high-pass bends the baseline.
  const bool rests_before = !moved_before && !options.moves_before && !(options.highpass_corner_Hz > 0);
  if (integrated.may_return && !late.held && !coloured && rests_before)
    late = final_rest_correction(integrated.accel_mps2, integrated.swing_m, signal.fs_Hz, rest);
  DriftFree out;
  if (coloured) {
    out = std::move(*coloured);
  } else {
    Motion& motion = integrated.motion;
    out.deflection = {.method = DeflectionMethod::drift_free,
                      .bias_mps2 = rest.bias(0) + late.bias(0),
                      .zero_mean_corrected = late.held,
                      .moved_before = moved_before};
    out.deflection.std_m.resize(integrated.accel_mps2.size());
    const double largest = largest_magnitude(motion.deflection_m);
    for (std::size_t i = 0; i < out.deflection.std_m.size(); ++i) {
      const double t_s = static_cast<double>(i) / signal.fs_Hz;
      const auto by_bias = drifted_deflection_m(t_s, options.highpass_corner_Hz);
      motion.deflection_m[i] -= late.bias.dot(by_bias);
      motion.velocity_mps[i] -= late.bias.dot(drifted_velocity_mps(t_s, options.highpass_corner_Hz));
      // t + Δt, because the noise of the first sample acts over the interval after it.
      const double noise = rest.noise_mps2 * rest.noise_mps2 * std::pow(t_s + 1 / signal.fs_Hz, 3) / (3 * signal.fs_Hz);
      const double bias = by_bias.dot(late.covariance * by_bias);
      out.deflection.std_m[i] = std::sqrt(std::max(0.0, noise + bias) + std::pow(kMethodError * largest, 2));
      out.deflection.drift_m = std::sqrt(std::max(0.0, bias));
    }
    out.deflection.velocity_mps = std::move(motion.velocity_mps);
    out.deflection.deflection_m = std::move(motion.deflection_m);
  }
  for (auto* values : {&out.deflection.velocity_mps, &out.deflection.deflection_m, &out.deflection.std_m})
    prepend_rest(*values, integrated.first);
  if (!out.levelled_mps2.empty()) prepend_rest(out.levelled_mps2, integrated.first);
  return out;
}

// Whether the peak is the double integral of a line that is no bias of the sensor. A structure that sways slowly moves
// along a line within the samples before the impact. Continued for seconds, this line makes metres.
bool is_made_by_motion_before(const ImpactSignal& signal, const DeflectionOptions& options, const Deflection& d) {
  if (!signal.level || d.zero_mean_corrected || !d.has_peak()) return false;
  const std::size_t first = std::min(samples_at_rest(signal), signal.accel_mps2.size() - 1);
  const BaselineEstimate rest =
      baseline_estimate(signal.accel_mps2.first(first), signal.fs_Hz, rms(signal.accel_mps2.subspan(first)));
  const double t_s = static_cast<double>(d.peak - std::min(d.peak, first)) / signal.fs_Hz;
  const Eigen::Vector2d by_bias = drifted_deflection_m(t_s, options.highpass_corner_Hz);
  const double by_line_m = std::abs(line_above_level(signal, rest).dot(by_bias));
  return by_line_m > kByLine * std::abs(d.peak_m) &&
         by_line_m > kNoBias * std::hypot(d.peak_std_m, signal.level->std_mps2 * by_bias(0));
}

Deflection drift_free_with_peak(const ImpactSignal& signal, const DeflectionOptions& options, bool moved_before) {
  DriftFree found = drift_free(signal, options, moved_before);
  ImpactSignal levelled = signal;
  if (!found.levelled_mps2.empty()) levelled.accel_mps2 = found.levelled_mps2;
  find_largest(levelled, options, found.deflection);
  return std::move(found.deflection);
}

Deflection small_interval(const ImpactSignal& signal) {
  const std::size_t first = std::min(samples_at_rest(signal), signal.accel_mps2.size() - 1);
  Motion motion = small_interval_sums(signal.accel_mps2.subspan(first), signal.fs_Hz);
  for (auto* values : {&motion.velocity_mps, &motion.deflection_m}) prepend_rest(*values, first);
  const double time_s = static_cast<double>(signal.accel_mps2.size() - first) / signal.fs_Hz;
  const BaselineEstimate rest = baseline_estimate(signal.accel_mps2.first(first), signal.fs_Hz, rms(signal.accel_mps2));
  return {.method = DeflectionMethod::small_interval,
          .velocity_mps = std::move(motion.velocity_mps),
          .deflection_m = std::move(motion.deflection_m),
          .drift_m = std::abs(rest.bias.dot(drifted_deflection_m(time_s, 0)))};
}

double strongest_line_Hz(std::span<const double> accel_mps2, double fs_Hz) {
  const auto lines = real_dft(accel_mps2);
  std::size_t best = 1;
  double largest = 0;
  // Lines 0 to 2 contain bias and drift.
  for (std::size_t k = 3; k < lines.size(); ++k) {
    const double deflection = std::abs(lines[k]) / std::pow(static_cast<double>(k), 2);
    if (deflection > largest) best = k;
    largest = std::max(largest, deflection);
  }
  return static_cast<double>(best) * fs_Hz / static_cast<double>(accel_mps2.size());
}

Deflection deflection_by_frequency(const ImpactSignal& signal, const DeflectionOptions& options) {
  const std::size_t first = std::min(samples_at_rest(signal), signal.accel_mps2.size() - 1);
  const BaselineEstimate rest = baseline_estimate(signal.accel_mps2.first(first), signal.fs_Hz, rms(signal.accel_mps2));
  std::vector<double> accel(signal.accel_mps2.begin(), signal.accel_mps2.end());
  for (double& value : accel) value -= rest.bias(0);
  const double lowest_Hz = options.lowest_Hz.value_or(kLowestShare * strongest_line_Hz(accel, signal.fs_Hz));
  Motion motion = integrate_in_frequency_domain(accel, signal.fs_Hz, options.highpass_corner_Hz, lowest_Hz);
  // The structure rests until the impact: this fixes the constants of integration.
  const double w0 = motion.deflection_m[first], v0 = motion.velocity_mps[first];
  for (std::size_t i = 0; i < accel.size(); ++i) {
    motion.deflection_m[i] = i < first ? 0 : motion.deflection_m[i] - w0;
    motion.velocity_mps[i] = i < first ? 0 : motion.velocity_mps[i] - v0;
  }
  return {.method = DeflectionMethod::frequency,
          .velocity_mps = std::move(motion.velocity_mps),
          .deflection_m = std::move(motion.deflection_m),
          .bias_mps2 = rest.bias(0)};
}

// The share of the motion that the modes do not explain, which may be missing from the deflection as well. Neighbouring
// samples of a motion are alike; those of the accelerometer's noise are not, so their products cancel.
double unexplained_share(std::span<const double> accel_mps2, std::span<const double> by_modes_mps2) {
  double unexplained = 0, explained = 0;
  for (std::size_t i = 1; i < accel_mps2.size(); ++i) {
    unexplained += (accel_mps2[i] - by_modes_mps2[i]) * (accel_mps2[i - 1] - by_modes_mps2[i - 1]);
    explained += by_modes_mps2[i] * by_modes_mps2[i];
  }
  unexplained = std::max(0.0, unexplained);
  return unexplained > 0 ? std::sqrt(unexplained / (unexplained + explained)) : 0;
}

// Compares a modal deflection with rigid-body motion to the double integral of the acceleration, without assuming a
// position of rest. A suspension pulls a body back, while the stated motion goes on for ever. The largest difference so
// far is then part of the standard deviation.
void add_contradiction(const ImpactSignal& signal, const DeflectionOptions& options, Deflection& modal) {
  if (options.moves_before || samples_at_rest(signal) < kMinBefore) return;
  ImpactSignal measured = signal;
  measured.rigid_per_kg = 0;
  DeflectionOptions free = options;
  free.free_body = true;
  const Deflection integral = drift_free(measured, free, signal.level.has_value()).deflection;
  const std::size_t samples = std::min(integral.deflection_m.size(), modal.deflection_m.size());
  const auto apart_m = [&](std::size_t i) { return std::abs(modal.deflection_m[i] - integral.deflection_m[i]); };
  const double relevant_m = kRelevant * largest_magnitude(modal.deflection_m);
  bool contradicted = false;
  double most_std_m = 0;  // of the modes so far: where they swing through zero, what they miss does not vanish
  for (std::size_t i = 0; i < samples; ++i) {
    most_std_m = std::max(most_std_m, modal.std_m[i]);
    const double limit_m = kRigidContradicted * std::hypot(most_std_m, integral.std_m[i]);
    contradicted = contradicted || apart_m(i) > std::max(relevant_m, limit_m);
  }
  if (!contradicted) return;
  modal.rigid_motion_contradicted = true;
  double most_m = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    most_m = std::max(most_m, apart_m(i));
    modal.std_m[i] = std::hypot(modal.std_m[i], most_m);
  }
}

Deflection by_modes(const ImpactSignal& signal, const DeflectionOptions& options) {
  assert(!signal.force_N.empty());
  ModalDeflection modal =
      modal_deflection(signal.force_N, signal.fs_Hz, signal.modes, signal.rigid_per_kg, signal.force_noise_N);
  const double missing = unexplained_share(signal.accel_mps2, modal.accel_mps2);
  for (std::size_t i = 0; i < modal.std_m.size(); ++i)
    modal.std_m[i] = std::hypot(modal.std_m[i], missing * modal.deflection_m[i]);
  Deflection out{.method = DeflectionMethod::modal,
                 .velocity_mps = std::move(modal.velocity_mps),
                 .deflection_m = std::move(modal.deflection_m),
                 .std_m = std::move(modal.std_m)};
  if (signal.rigid_per_kg > 0) {
    add_contradiction(signal, options, out);
  } else {
    out.rigid_motion_left_out = !drift_free(signal, options).deflection.zero_mean_corrected;
  }
  return out;
}

}  // namespace

const char* name_of(DeflectionMethod method) {
  switch (method) {
    case DeflectionMethod::automatic:
      return "auto";
    case DeflectionMethod::small_interval:
      return "small-interval";
    case DeflectionMethod::drift_free:
      return "drift-free";
    case DeflectionMethod::frequency:
      return "frequency";
    case DeflectionMethod::modal:
      return "modal";
  }
  return "";
}

Deflection deflection_of(const ImpactSignal& signal, const DeflectionOptions& options) {
  assert(!signal.accel_mps2.empty());
  DeflectionMethod method = options.method;
  if (method == DeflectionMethod::automatic) {
    const bool modal = samples_at_rest(signal) < kMinBefore && !signal.force_N.empty() && !signal.modes.empty();
    method = modal ? DeflectionMethod::modal : DeflectionMethod::drift_free;
  }
  if (method == DeflectionMethod::drift_free) {
    Deflection found = drift_free_with_peak(signal, options, false);
    return is_made_by_motion_before(signal, options, found) ? drift_free_with_peak(signal, options, true) : found;
  }
  Deflection out = method == DeflectionMethod::small_interval ? small_interval(signal)
                   : method == DeflectionMethod::frequency    ? deflection_by_frequency(signal, options)
                                                              : by_modes(signal, options);
  find_largest(signal, options, out);
  return out;
}

FlickerEvidence flicker_evidence(const ImpactSignal& signal, const DeflectionOptions& options) {
  assert(!signal.accel_mps2.empty());
  Integrated integrated = integrate_after_rest(signal, options);
  return {.log_gains = noise_of(integrated, signal.fs_Hz, options.highpass_corner_Hz).log_gains(),
          .motion = std::make_shared<const Motion>(std::move(integrated.motion))};
}

std::optional<SensorLevel> sensor_level(std::span<const double> before_mps2, double fs_Hz) {
  if (before_mps2.size() < kMinLevel) return std::nullopt;
  const BaselineEstimate rest = baseline_estimate(before_mps2, fs_Hz, 0);
  const auto n = static_cast<double>(before_mps2.size());
  const double half_s = (n + 1) / 2 / fs_Hz;  // from the middle of the samples to the one after them
  return SensorLevel{.mps2 = rest.bias(0) - rest.bias(1) * half_s,
                     .std_mps2 = std::hypot(rest.noise_mps2 / std::sqrt(n), rest.bias(1) * half_s)};
}

double motion_onset_s(std::span<const double> accel_mps2, double fs_Hz) {
  const std::size_t quiet = std::min(accel_mps2.size(), std::max<std::size_t>(kMinBefore, accel_mps2.size() / 50));
  const Spread noise = spread_of({accel_mps2.begin(), accel_mps2.begin() + static_cast<std::ptrdiff_t>(quiet)});
  const double largest = extremes_of(accel_mps2).max_distance_from(noise.median);
  const double level = std::max(kOnsetNoise * noise.robust_std, kOnsetLevel * largest);
  const auto moves = [&](double a) { return std::abs(a - noise.median) > level; };
  auto first = std::find_if(accel_mps2.begin(), accel_mps2.end(), moves);
  // A glitch, such as a filter that settles at the start of the record, is weak and over before the impact.
  while (first != accel_mps2.end()) {
    auto last = first;
    auto next = std::find_if(last + 1, accel_mps2.end(), moves);
    while (next != accel_mps2.end() && next - last <= kQuietAfterGlitch) {
      last = next;
      next = std::find_if(last + 1, accel_mps2.end(), moves);
    }
    const auto weak = [&](double a) { return std::abs(a - noise.median) < kGlitch * largest; };
    if (next == accel_mps2.end() || !std::all_of(first, last + 1, weak)) break;
    first = next;
  }
  return static_cast<double>(first - accel_mps2.begin()) / fs_Hz;
}

}  // namespace percuss::metrics
