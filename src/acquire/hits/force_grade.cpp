#include "acquire/hits/force_grade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acquire/hits/clipping.hpp"
#include "core/io/counted_words.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kWeak = 0.2;          // of the median peak
constexpr double kLateTrigger = 0.05;  // of the peak, at the first sample

}  // namespace

void grade_pulse(Hit& hit, std::span<const double> x, const PulseShape& pulse, bool starts_in_pulse) {
  const double peak = std::abs(hit.peak_N);
  const double at_start = std::abs(x.front()) / peak;
  if (starts_in_pulse && (!pulse.has_rise || at_start > kLateTrigger)) {
    hit.findings.push_back({.code = FindingCode::late_trigger,
                            .severity = Severity::reject,
                            .value = at_start,
                            .message = fmt::format("the record starts inside the pulse, at {:.0f} % of its peak; "
                                                   "set a pre-trigger on the recorder",
                                                   at_start * 100)});
  }
  const auto rise = static_cast<std::size_t>(std::max(0.0, pulse.rise));
  const std::size_t fall = std::min(x.size(), static_cast<std::size_t>(pulse.fall) + 2);
  const auto within = x.subspan(rise, fall - rise);
  std::size_t clipped = count_clipped_samples(within, block_extremes(within, kClippingBlock), x, 0);
  if (clipped == 0 && is_flat_pair(within, x)) clipped = 2;
  if (clipped > 0) {
    hit.findings.push_back(
        {.code = FindingCode::overload,
         .severity = Severity::reject,
         .value = static_cast<double>(clipped),
         .message = fmt::format("force clipped in {} sample{}; raise the input range", clipped, plural(clipped))});
  }
  if (hit.peak_N < 0) {
    hit.findings.push_back({.code = FindingCode::polarity,
                            .severity = Severity::warn,
                            .value = hit.peak_N,
                            .message = "the force pulse is negative, but a hammer only pushes, so the FRFs of this hit "
                                       "have the wrong sign; give the scale of its force the other sign",
                            .options = {"force_scale"}});
  }
}

void grade_weak(std::vector<Hit>& hits) {
  std::vector<double> peaks;
  for (const Hit& hit : hits) {
    if (hit.peak_N != 0) peaks.push_back(std::abs(hit.peak_N));
  }
  const double median_N = median(peaks);
  for (Hit& hit : hits) {
    const double ratio = std::abs(hit.peak_N) / median_N;
    if (hit.peak_N == 0 || ratio >= kWeak) continue;
    hit.findings.push_back({.code = FindingCode::weak,
                            .severity = Severity::warn,
                            .value = ratio,
                            .message = fmt::format("weak hit of {:.3g} N, {:.0f} % of the median hit",
                                                   std::abs(hit.peak_N), ratio * 100)});
  }
}

void grade_bandwidth(std::vector<Hit>& hits, double band_high_Hz) {
  for (Hit& hit : hits) {
    if (hit.peak_N == 0 || hit.bandwidth_Hz >= band_high_Hz) continue;
    hit.findings.push_back(
        {.code = FindingCode::low_bandwidth,
         .severity = Severity::warn,
         .value = hit.bandwidth_Hz,
         .message = fmt::format("the force reaches {:.0f} Hz (−20 dB), the band ends at {:.0f} Hz; use a harder tip "
                                "or narrow the band",
                                hit.bandwidth_Hz, band_high_Hz),
         .options = {"band"}});
  }
}

}  // namespace percuss::acquire
