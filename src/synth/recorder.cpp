#include "synth/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/statistics.hpp"
#include "synth/random_stream.hpp"

namespace percuss::synth {
namespace {

constexpr std::uint64_t kForceNoiseStream = 2, kAccelNoiseStream = 3;
constexpr double kHeadroom = 1.5;  // automatic full scale / largest value

void clip_and_round(double limit, double step, std::span<double> values) {
  for (double& v : values) {
    v = std::clamp(v, -limit, limit);
    if (step > 0) v = step * std::nearbyint(v / step);
  }
}

bool touches(double limit, double step, std::span<const double> values) {
  // Quantisation may move a clipped value by half a step.
  return std::any_of(values.begin(), values.end(), [&](double v) { return std::abs(v) >= limit - 0.5 * step; });
}

// The limit and the step of one kind of channel.
std::pair<double, double> limit_and_step(std::optional<double> clip, std::optional<double> range, int bits,
                                         double peak) {
  double limit = clip.value_or(std::numeric_limits<double>::infinity());
  if (bits == 0) return {limit, 0};
  const double full_scale = range.value_or(peak > 0 ? kHeadroom * peak : 1);
  return {std::min(limit, full_scale), std::ldexp(full_scale, 1 - bits)};
}

}  // namespace

RecorderRange recorder_range(const SynthRecorder& recorder, const SynthSamples& clean) {
  double force = 0, accel = 0;
  for (const auto& row : clean.force_N) force = std::max(force, extremes_of(row).max_distance_from(0));
  for (const auto& row : clean.accel_mps2) {
    for (const auto& channel : row) accel = std::max(accel, extremes_of(channel).max_distance_from(0));
  }
  const auto [force_limit, force_step] = limit_and_step(recorder.force_clip_N, recorder.force_range_N, recorder.bits,
                                                        force + std::abs(recorder.force_bias_N));
  const auto [accel_limit, accel_step] = limit_and_step(recorder.accel_clip_mps2, recorder.accel_range_mps2,
                                                        recorder.bits, accel + std::abs(recorder.accel_bias_mps2));
  return {force_limit, accel_limit, force_step, accel_step};
}

void record_row(const Truth& truth, const RecorderRange& range, std::size_t row, std::vector<double>& force_N,
                std::vector<std::vector<double>>& accel_mps2) {
  const SynthSpec& spec = truth.spec;
  const SynthRecorder& recorder = spec.recorder;
  if (truth.force_noise_N > 0) RandomStream{spec.seed, kForceNoiseStream, row}.add_normal(truth.force_noise_N, force_N);
  for (double& f : force_N) f += recorder.force_bias_N;
  clip_and_round(range.force_limit_N, range.force_step_N, force_N);
  for (std::size_t c = 0; c < accel_mps2.size(); ++c) {
    const double sigma = truth.accel_noise_mps2[c];
    if (sigma > 0) RandomStream{spec.seed, kAccelNoiseStream, row, c}.add_normal(sigma, accel_mps2[c]);
    const double drift = recorder.accel_drift_mps2_per_s / spec.fs_Hz;
    for (std::size_t n = 0; n < accel_mps2[c].size(); ++n) {
      accel_mps2[c][n] += recorder.accel_bias_mps2 + drift * static_cast<double>(n);
    }
    clip_and_round(range.accel_limit_mps2, range.accel_step_mps2, accel_mps2[c]);
  }
}

void flag_clipped(const RecorderRange& range, const SynthSamples& recorded, double fs_Hz, std::vector<TrueHit>& hits) {
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].flag != "good") continue;
    const std::size_t row = hits[h].row, size = recorded.force_N[row].size();
    const bool shared = h + 1 < hits.size() && hits[h + 1].row == row;
    const auto sample = [&](double t_s) {
      return static_cast<std::size_t>(std::clamp(t_s * fs_Hz, 0.0, static_cast<double>(size)));
    };
    const std::size_t first = sample(hits[h].onset_s), last = shared ? sample(hits[h + 1].onset_s) : size;
    const auto part = [&](const std::vector<double>& x) { return std::span(x).subspan(first, last - first); };
    bool clipped = touches(range.force_limit_N, range.force_step_N, part(recorded.force_N[row]));
    for (const auto& channel : recorded.accel_mps2[row]) {
      clipped = clipped || touches(range.accel_limit_mps2, range.accel_step_mps2, part(channel));
    }
    if (clipped) hits[h].flag = "clipped";
  }
}

}  // namespace percuss::synth
