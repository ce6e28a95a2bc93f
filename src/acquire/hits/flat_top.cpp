#include "acquire/hits/flat_top.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "acquire/hits/pulse_shape.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::acquire {
namespace {

// No elastic contact is flatter than a half-sine, 0.51; measured pulses of hammers have 0.30 to 0.48. The limit leaves
// 0.03 for noise.
constexpr double kMaxFlatness = 0.54;
// An ideal low-pass filter at 0.35 to 0.5 of the sampling rate makes half-sines shorter than kShortPulse as flat as
// 0.554. Such a pulse is clipped if it exceeds kMaxShortFlatness, or the median of the pulses of about its length by
// kFlatterThanOthers: due to the filter, a change of the length by a tenth changes the flatness by 0.04.
constexpr double kShortPulse = 8;  // samples above 30 % of the peak
constexpr double kMaxShortFlatness = 0.58, kFlatterThanOthers = 0.07, kSimilarLength = 0.15;
constexpr std::size_t kMinOthers = 2;
constexpr double kHigh = 0.8, kLow = 0.3;  // of the peak
// Of the peak. A flank is cut off where one of two neighbouring samples exceeds kFlank and the other is below kZero.
constexpr double kFlank = 0.2, kZero = 0.01;
constexpr double kMinSignal = 30;  // peak over noise: the noise changes the flatness by a few hundredths
constexpr std::size_t kOversampling = 16, kKernel = 16;
constexpr std::size_t kFlopsPerTop = 50'000;  // of the measurement of one pulse
constexpr std::size_t kLongPulse = 32;        // samples, of a pulse that needs no interpolation
// Largest amplitude near half the sampling rate, over the pulse's impulse. It changes the flatness by about 0.02.
constexpr double kMaxAlias = 0.005;

// [kOversampling][2 kKernel]: weights at the place step / kOversampling after sample n. They belong to the samples
// n + 1 − kKernel … n + kKernel.
using InterpolationWeights = std::array<std::array<double, 2 * kKernel>, kOversampling>;

InterpolationWeights interpolation_weights() {
  InterpolationWeights weights{};
  for (std::size_t step = 1; step < kOversampling; ++step) {
    for (std::size_t n = 0; n < 2 * kKernel; ++n) {
      const double away = static_cast<double>(step) / static_cast<double>(kOversampling) +
                          static_cast<double>(kKernel) - 1 - static_cast<double>(n);
      const double turn = std::numbers::pi * away;
      const double window = 0.5 + 0.5 * std::cos(turn / static_cast<double>(kKernel));
      weights[step][n] = std::sin(turn) / turn * window;
    }
  }
  return weights;
}

// Band-limited interpolation of the top of a pulse, which has few samples there if it is short. The top reaches to the
// next sample on either side that is below kLow of the largest one.
std::vector<double> interpolated(const std::vector<double>& x) {
  static const InterpolationWeights weights = interpolation_weights();
  auto begin = static_cast<std::size_t>(std::max_element(x.begin(), x.end()) - x.begin());
  std::size_t last = begin;
  const double low = kLow * x[begin];
  while (begin > 0 && x[begin] >= low) --begin;
  while (last + 1 < x.size() && x[last] >= low) ++last;
  std::vector<double> out((last - begin) * kOversampling + 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t at = begin + i / kOversampling, step = i % kOversampling;
    if (step == 0) {
      out[i] = x[at];
      continue;
    }
    const std::size_t first = at + 1 > kKernel ? at + 1 - kKernel : 0;
    const std::size_t end = std::min(x.size(), at + 1 + kKernel);
    const double* weight = weights[step].data() + (first + kKernel - 1 - at);
    std::array<double, 4> sum{};  // independent sums, for instruction-level parallelism
    std::size_t n = first;
    for (; n + 4 <= end; n += 4, weight += 4) {
      for (std::size_t k = 0; k < 4; ++k) sum[k] += x[n + k] * weight[k];
    }
    for (; n < end; ++n, ++weight) sum[0] += x[n] * *weight;
    out[i] = sum[0] + sum[1] + (sum[2] + sum[3]);
  }
  return out;
}

// The length of the top around `peak` that is above `level`, in samples; interpolated linearly at both ends.
double length_above(const std::vector<double>& x, std::size_t peak, double level) {
  std::size_t first = peak, last = peak;
  while (first > 0 && x[first] >= level) --first;
  while (last + 1 < x.size() && x[last] >= level) ++last;
  const auto part = [&](std::size_t inner, std::size_t outer) {
    return x[inner] > x[outer] ? std::clamp((x[inner] - level) / (x[inner] - x[outer]), 0.0, 1.0) : 0.0;
  };
  if (last == first) return 0;
  return static_cast<double>(last - first) - 2 + part(first + 1, first) + part(last - 1, last);
}

// The pulse above 5 % of its peak, and beside it the samples that its interpolation needs.
std::vector<double> pulse_of(const Hit& hit) {
  const double sign = hit.peak_N < 0 ? -1 : 1;
  const PulseShape shape = shape_of_pulse(hit.gated_N, hit.peak - hit.gate_first);
  const auto rise = static_cast<std::size_t>(shape.rise), fall = static_cast<std::size_t>(shape.fall) + 1;
  std::vector<double> x;
  for (std::size_t n = rise; n < fall + 2 * kKernel; ++n) {
    const bool inside = n >= kKernel && n - kKernel < hit.gated_N.size();
    x.push_back(inside ? sign * hit.gated_N[n - kKernel] : 0);
  }
  return x;
}

// Whether a force window of the recorder cuts off a flank: the pulse is then shorter than the contact. Such a force is
// constant outside the window.
bool has_cut_flank(const Hit& hit) {
  if (hit.noise_N > 0) return false;
  const double peak = std::abs(hit.peak_N);
  const auto& x = hit.gated_N;
  for (std::size_t n = 0; n <= x.size(); ++n) {
    const double before = n > 0 ? std::abs(x[n - 1]) : 0, after = n < x.size() ? std::abs(x[n]) : 0;
    if (std::max(before, after) > kFlank * peak && std::min(before, after) < kZero * peak) return true;
  }
  return false;
}

// Whether the spectrum of the pulse exceeds the noise near half the sampling rate: the samples then do not show the
// shape. Recorders with an anti-alias filter leave nothing there.
bool is_aliased(const std::vector<double>& pulse, double noise) {
  constexpr std::array<double, 2> kOfNyquist{0.96, 1.0};
  double impulse = 0, power = 0;
  for (const double x : pulse) impulse += x;
  for (const double share : kOfNyquist) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < pulse.size(); ++n)
      sum += pulse[n] * std::polar(1.0, -std::numbers::pi * share * static_cast<double>(n));
    power += std::norm(sum) / static_cast<double>(kOfNyquist.size());
  }
  power -= noise * noise * static_cast<double>(pulse.size());
  return power > std::pow(kMaxAlias * impulse, 2);
}

bool holds_its_peak(const Hit& hit) {
  return hit.peak >= hit.gate_first && hit.peak - hit.gate_first < hit.gated_N.size();
}

struct PulseTop {
  double flatness = 0;
  double length = 0;  // samples above 30 % of the peak
};

PulseTop top_of(const std::vector<double>& pulse) {
  const bool is_long = pulse.size() >= 2 * kKernel + kLongPulse;
  const std::vector<double> x = is_long ? pulse : interpolated(pulse);
  const auto peak = static_cast<std::size_t>(std::max_element(x.begin(), x.end()) - x.begin());
  const double low = length_above(x, peak, kLow * x[peak]);
  if (!(low > 0)) return {};
  return {.flatness = length_above(x, peak, kHigh * x[peak]) / low,
          .length = low / static_cast<double>(is_long ? 1 : kOversampling)};
}

std::optional<PulseTop> top_of(const Hit& hit) {
  if (!holds_its_peak(hit) || std::abs(hit.peak_N) < kMinSignal * hit.noise_N ||
      has_finding(hit.findings, FindingCode::overload) || has_cut_flank(hit))
    return std::nullopt;
  const std::vector<double> pulse = pulse_of(hit);
  if (is_aliased(pulse, hit.noise_N)) return std::nullopt;
  return top_of(pulse);
}

// Whether a pulse is flatter than the median of the unclipped pulses of about its length.
bool is_flatter_than_others(const PulseTop& top, const std::vector<std::optional<PulseTop>>& tops) {
  std::vector<double> others;
  for (const std::optional<PulseTop>& other : tops) {
    if (other && other->flatness <= kMaxFlatness && std::abs(other->length - top.length) < kSimilarLength * top.length)
      others.push_back(other->flatness);
  }
  if (others.size() < kMinOthers) return false;
  return top.flatness > median(std::move(others)) + kFlatterThanOthers;
}

bool is_clipped(const PulseTop& top, const std::vector<std::optional<PulseTop>>& tops) {
  if (top.flatness <= kMaxFlatness) return false;
  return top.length >= kShortPulse || top.flatness > kMaxShortFlatness || is_flatter_than_others(top, tops);
}

}  // namespace

double top_flatness(const Hit& hit) { return holds_its_peak(hit) ? top_of(pulse_of(hit)).flatness : 0; }

void grade_flat_tops(std::vector<Hit>& hits) {
  std::vector<std::optional<PulseTop>> tops(hits.size());
  parallel_for_cost(hits.size(), kFlopsPerTop, [&](std::size_t h) { tops[h] = top_of(hits[h]); });
  // Where the amplifier clipped one hit, it clipped the other flat ones, too.
  if (std::none_of(tops.begin(), tops.end(), [&](const auto& top) { return top && is_clipped(*top, tops); })) return;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (!tops[h] || tops[h]->flatness <= kMaxFlatness) continue;
    hits[h].findings.push_back(
        {.code = FindingCode::force_clipped,
         .severity = Severity::reject,
         .value = tops[h]->flatness,
         .message = fmt::format(
             "force clipped before the recorder's filter: the pulse has a flat top (at 80 % of its "
             "peak it is {:.0f} % as long as at 30 %; without clipping, at most about 50 %); lower the gain of the "
             "hammer's amplifier or hit softer",
             tops[h]->flatness * 100)});
  }
}

}  // namespace percuss::acquire
