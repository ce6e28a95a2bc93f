#include "pipeline/source/modes_beyond.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "core/math/statistics.hpp"
#include "frf/spectra.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kBeyond = 0.10;         // of the band's width: further away, the residual terms follow the flank
constexpr double kMaxBeyond = 0.20;      // of the band's width: limit of all added lines
constexpr double kMinAmplitude = 0.2;    // of the largest one in the band
constexpr double kMinPowerRatio = 20;    // of a peak to the median of the lines
constexpr double kBandwidthsBeyond = 5;  // half-power bandwidths from the peak to the new end
constexpr std::size_t kMaxHits = 8, kMaxChannels = 4;  // whose power spectra are summed

struct Peak {
  double freq_Hz = 0;
  double half_power_Hz = 0;
};

// The distance between the lines around a maximum at which the power has fallen to half of it.
double half_power_Hz(const acquire::LineRange& lines, std::span<const double> power, std::size_t top) {
  std::size_t low = top, high = top;
  while (low > 0 && power[low] > 0.5 * power[top]) --low;
  while (high + 1 < power.size() && power[high] > 0.5 * power[top]) ++high;
  return static_cast<double>(high - low) * lines.df_Hz();
}

// The largest peak of the lines up to to_Hz that lies beyond end_Hz, or less than its bandwidth below.
std::optional<Peak> strong_peak(double end_Hz, double to_Hz, double least_power, const acquire::LineRange& lines,
                                std::span<const double> power) {
  std::optional<Peak> out;
  double most = least_power;
  for (std::size_t k = 1; k + 1 < power.size() && lines.freq_Hz(k) <= to_Hz; ++k) {
    const double freq_Hz = lines.freq_Hz(k);
    if (!(power[k] > most) || power[k] < power[k - 1] || power[k] <= power[k + 1]) continue;
    const Peak peak{.freq_Hz = freq_Hz, .half_power_Hz = half_power_Hz(lines, power, k)};
    if (freq_Hz + peak.half_power_Hz <= end_Hz) continue;
    out = peak;
    most = power[k];
  }
  return out;
}

// Up to `most` of the indices 0 … count − 1, evenly spread.
std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> out;
  const std::size_t used = std::min(count, most);
  for (std::size_t i = 0; i < used; ++i) out.push_back(i * count / used);
  return out;
}

// The first accepted hit of each point, or all accepted hits of the only point.
std::vector<std::size_t> hits_of_points(const std::vector<AnalysedHit>& hits) {
  std::vector<std::size_t> first, all = accepted_hits(hits);
  std::set<int> seen;
  for (const std::size_t h : all) {
    if (seen.insert(hits[h].point).second) first.push_back(h);
  }
  return first.size() > 1 ? first : all;
}

}  // namespace

double furthest_end_Hz(double end_Hz, std::pair<double, double> band_Hz) {
  return end_Hz + kMaxBeyond * (band_Hz.second - band_Hz.first);
}

double end_past_modes(double end_Hz, std::pair<double, double> band_Hz, const acquire::LineRange& lines,
                      std::span<const double> power) {
  const auto [low_Hz, high_Hz] = band_Hz;
  double largest = 0;
  for (std::size_t k = 0; k < power.size(); ++k) {
    if (lines.freq_Hz(k) >= low_Hz && lines.freq_Hz(k) <= high_Hz) largest = std::max(largest, power[k]);
  }
  const bool finite = std::all_of(power.begin(), power.end(), [](double p) { return std::isfinite(p); });
  if (!finite || !(largest > 0)) return end_Hz;  // samples may be missing
  const double furthest_Hz = std::min(furthest_end_Hz(end_Hz, band_Hz), lines.freq_Hz(lines.count - 1));
  const double least_power =
      std::max(kMinAmplitude * kMinAmplitude * largest, kMinPowerRatio * median({power.begin(), power.end()}));
  const double reach_Hz = kBeyond * (high_Hz - low_Hz);
  double end = end_Hz;
  while (const auto peak = strong_peak(end, std::min(end + reach_Hz, furthest_Hz), least_power, lines, power)) {
    if (peak->freq_Hz + peak->half_power_Hz > furthest_Hz) break;  // its other flank would be missing
    end = std::min(furthest_Hz, peak->freq_Hz + kBandwidthsBeyond * peak->half_power_Hz);
  }
  return end;
}

std::vector<double> response_power(const std::vector<AnalysedHit>& hits, const HitResponses& responses,
                                   const TransformOptions& options) {
  constexpr double kMinForcePower = 0.01;  // of the largest: keeps lines without force from dominating
  const acquire::LineRange& lines = options.lines;
  std::vector<double> power(lines.count);
  if (power.empty()) return power;
  const std::vector<std::size_t> of_points = hits_of_points(hits);
  for (const std::size_t i : evenly_spaced(of_points.size(), kMaxHits)) {
    const std::size_t h = of_points[i];
    const auto force =
        frf::force_spectrum(frf::force_block(hits[h].hit, lines.fs_Hz, options.window_decay_per_s), lines);
    double largest = 0;
    for (const Complex f : force) largest = std::max(largest, std::norm(f));
    if (!(largest > 0)) continue;
    for (const std::size_t channel : evenly_spaced(responses.of[h].size(), kMaxChannels)) {
      const std::span<const Complex> response = responses.of[h][channel].spectrum;
      for (std::size_t k = 0; k < power.size(); ++k)
        power[k] += std::norm(response[k]) / std::max(std::norm(force[k]), kMinForcePower * largest);
    }
  }
  return power;
}

acquire::LineRange end_spectra_past_modes(HitResponses& responses, const std::vector<AnalysedHit>& hits,
                                          std::pair<double, double> band_Hz, double end_Hz,
                                          const TransformOptions& options) {
  acquire::LineRange lines = options.lines;
  if (lines.freq_Hz(lines.count) > end_Hz + lines.df_Hz())  // else there is nothing to choose
    end_Hz = end_past_modes(end_Hz, band_Hz, lines, response_power(hits, responses, options));
  const acquire::LineRange ended = frf::lines_in_band(lines.fs_Hz, lines.samples, lines.freq_Hz(0), end_Hz);
  lines.count = std::min(lines.count, ended.first + ended.count - lines.first);
  for (std::vector<HitResponse>& of_hit : responses.of) {
    for (HitResponse& one : of_hit) one.spectrum = one.spectrum.first(lines.count);
  }
  return lines;
}

}  // namespace percuss::pipeline
